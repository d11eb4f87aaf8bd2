"""The addresses of the sources that the notebooks name.

Each DOI is the one by which other public bibliographies name the same title.
"""

DOI = "https://doi.org/"

# {words of a source as a notebook writes them: its address}; the words become the link.
ADDRESSES = {
    "Modern Robotics": f"{DOI}10.1017/9781316661239",
    "State Estimation for Robotics": f"{DOI}10.1017/9781316671528",
    "A generalized solution of the orthogonal Procrustes problem": f"{DOI}10.1007/BF02289451",
    "A discussion of the solution for the best rotation to relate two sets of vectors": (
        f"{DOI}10.1107/S0567739478001680"
    ),
    "A32, 1976": f"{DOI}10.1107/S0567739476001873",
    "S. Umeyama": f"{DOI}10.1109/34.88573",
    "Quaternion from rotation matrix": f"{DOI}10.2514/3.55767b",
    "Animating rotation with quaternion curves": f"{DOI}10.1145/325165.325242",
    "Uniform random rotations": f"{DOI}10.1016/B978-0-08-050755-2.50036-1",
    "Effective sampling and distance metrics for 3D rigid body path planning": (
        f"{DOI}10.1109/ROBOT.2004.1308895"
    ),
    "A Mathematical Introduction to Robotic Manipulation": f"{DOI}10.1201/9781315136370",
    "IK-Geo: unified robot inverse kinematics using subproblem decomposition": (
        "https://arxiv.org/abs/2211.05737"
    ),
    "Inverse kinematic solutions with singularity robustness for robot manipulator control": (
        f"{DOI}10.1115/1.3143764"
    ),
    "C. W. Wampler": f"{DOI}10.1109/TSMC.1986.289285",
    "Robotic manipulators and the product of exponentials formula": f"{DOI}10.1007/BFb0031048",
    "B. Siciliano, L. Sciavicco, L. Villani and G. Oriolo": f"{DOI}10.1007/978-1-84628-642-1",
    "J. Denavit and R. S. Hartenberg": f"{DOI}10.1115/1.4011045",
    "T. Sugihara": f"{DOI}10.1109/TRO.2011.2148230",
    "Multiple View Geometry": f"{DOI}10.1017/CBO9780511811685",
    "Least squares quantization in PCM": f"{DOI}10.1109/TIT.1982.1056489",
    "Locally weighted learning for control": f"{DOI}10.1023/A:1006511328852",
    "Learning inverse kinematics": f"{DOI}10.1109/IROS.2001.973374",
    "Stable Mappings and Their Singularities": f"{DOI}10.1007/978-1-4615-7904-5",
    "Scikit-learn: machine learning in Python": ("https://jmlr.org/papers/v12/pedregosa11a.html"),
    "Chialiang86/Robot-Manipulation-Framework": (
        "https://github.com/Chialiang86/Robot-Manipulation-Framework"
    ),
    "righetti/ROB6003": "https://github.com/righetti/ROB6003",
}
