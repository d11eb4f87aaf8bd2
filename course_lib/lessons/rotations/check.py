"""Checks of notebook 1, rotations: ``from course_lib.lessons.rotations import check``."""

from course_lib.checks.notebook import namespace
from course_lib.checks.prediction import Prediction

EXERCISES = (
    "rotate_point",
    "compose",
    "mug_orientation",
    "exp_so3",
    "gyroscope",
    "test_log_so3",
    "log_so3",
    "nearest_so",
)

MORE = (
    "euler_angles",
    "slerp",
    "quaternion_to_matrix",
    "matrix_to_quaternion",
    "is_valid",
    "nearest_se",
    "random_rotations",
    "random_quaternions",
)

PREDICTIONS = (
    Prediction(
        "drift",
        "c",
        {
            "a": (
                "A thousand errors of half a percent do not stay half a percent: each product"
                " stretches what the products before it have stretched."
            ),
            "b": (
                "That adds the errors up, 1 + 1000 * 0.0049. But each factor multiplies the length "
                "reached so far."
            ),
            "c": "1.0049 to the power 1000 is 133: errors of factors multiply.",
        },
        more=True,
    ),
    Prediction(
        "order",
        "a",
        {
            "a": (
                "In Rz Rx, the factor Rx stands next to the point and acts first, about the fixed x"
                " axis, which leaves x alone. Rz then takes x to y."
            ),
            "b": (
                "That is the other product, Rx Rz: there z acts first and takes x to y, and x "
                "takes that y to z."
            ),
            "c": "Rx leaves its own axis where it is, but then Rz moves it.",
        },
    ),
    Prediction(
        "gyro",
        "b",
        {
            "a": (
                "These are its coordinates in the room, omega_s. The gyroscope is carried along:"
                " which of its axes points up?"
            ),
            "b": (
                "Banked by 90 degrees, the drone's own y axis points up, and does so all the way"
                " round. So omega_b = R^T omega_s is (0, 1, 0) at every time."
            ),
            "c": (
                "The drone's x and z axes do change their directions. But which axis points up all "
                "the time?"
            ),
        },
    ),
    Prediction(
        "lock",
        "b",
        {
            "a": (
                "Roll and yaw have changed. But about which fixed axis does the roll rotate at "
                "pitch pi/2?"
            ),
            "b": (
                "At pitch pi/2 only alpha - gamma matters, and it is 0.2 both times: one degree of "
                "freedom is lost."
            ),
            "c": (
                "The pitch is exactly pi/2 here, so the two matrices are equal: not only nearly, "
                "or in a limit."
            ),
        },
    ),
    Prediction(
        "cover",
        "b",
        {
            "a": (
                "That holds for the matrix. But the quaternion contains the cosine and sine of "
                "half the angle."
            ),
            "b": (
                "cos(pi) = -1: after one revolution the quaternion is at -q, which stands for the "
                "same rotation."
            ),
            "c": "It would be so after 180 degrees: cos(pi/2) = 0.",
        },
        more=True,
    ),
    Prediction(
        "rare",
        "c",
        {
            "a": (
                "That share would be right if the angle were uniform: 10 of 180 degrees. But its"
                " density is nearly 0 for small angles."
            ),
            "b": (
                "That is the share of a cap of 10 degrees on an ordinary sphere. Rotations have "
                "one dimension more."
            ),
            "c": (
                "There is little room near the identity: the share grows as the third power of the "
                "angle."
            ),
        },
        more=True,
    ),
    Prediction(
        "other_frame",
        "b",
        {
            "a": (
                "A distance should have this property. Do roll, pitch and yaw of R R1 depend on R "
                "in a simple way?"
            ),
            "b": (
                "The rotation from one to the other, R1^T R2, stays the same, and so do its angle "
                "and its quaternion. Roll, pitch and yaw change by different amounts."
            ),
            "c": (
                "The quaternion distance is 1 - cos(a/2), a function of the angle. If the angle "
                "stays, so does this distance."
            ),
        },
        more=True,
    ),
)

STOP = ("gyroscope", "Back again: the logarithm")
globals().update(namespace(__name__, EXERCISES, PREDICTIONS, MORE, STOP))
