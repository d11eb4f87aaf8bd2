"""Mutants of the notebooks' solutions that their checks accept, and why; see test_mutants.py."""

# Why a mutant answers as the solution does, as far as the task asks.
REASONS = {
    "order": "exchanging the two changes nothing: a sum, a product of a number, a distance, or a list of solutions",
    "transposed": (
        "the number is the same for the transpose: its shape or length here, R R^T = 1 as R^T R = 1, det R^T = det R"
    ),
    "symmetric": "the matrix is its own transpose",
    "vector": "a vector has no transpose in numpy: it stays as it is",
    "sign": (
        "cos(-a) = cos(a); the sign of a zero, of NaN or of a length does not show, and two changed signs cancel each "
        "other"
    ),
    "either sign": "q and -q are the same rotation, a singular vector has two signs, and either is right",
    "another sample": "a test that tries other rotations, or another tolerance, distinguishes the versions as well",
    "half turn": "at an angle of pi either sign of the axis is right, and R + I is symmetric",
    "bound": "only an input exactly on the bound shows it, and on either side the result is the same up to rounding",
    "rounding": "what is added, dropped or changed is smaller than the rounding that the check allows",
    "distribution": "the angles are uniform over a revolution, so the answers have the same distribution",
    "mean": "the weighted differences from the mean add up to zero, so what is added to the other factor drops out",
    "axis part": "the other factor is perpendicular to the axis, so a part along the axis drops out",
    "touching": (
        "it matters only if circles touch exactly, or if a tolerance is 0: there rounding decides, right answers "
        "differ, and no case asks"
    ),
    "another cut": "another start of k-means, and at times another cut: any cut that is as good is right",
    "unasked": "it matters only for inputs of which the task says nothing, or for which it accepts any answer",
    "same place": "the last axis of an array of this many dimensions, or the same integer once numpy has rounded it",
    "free choice": "the task leaves it to the student: a damping, a tolerance below the required one, a seed",
    "any point": (
        "any point on an axis is right, and any configuration of the family, and so is any pose that a test tries"
    ),
    "rows": "the number of different rows is the same, and an empty array has none",
}

# {exercise: {the changed line: the key of its reason}}
EQUIVALENT = {
    "rotate_point": {
        "c, s = (np.cos(-a), np.sin(a))": "sign",
    },
    "exp_so3": {
        "a = -np.linalg.norm(w)": "sign",
        "return np.eye(3) + np.sin(a) * N + N @ ((1 - np.cos(a)) * N)": "order",
    },
    "test_log_so3": {
        "... ay([[1.0, 0, 0], [0, 0.6, -0.8800000000000001], [-0.48, 0.6, 0.64]]): ...": "another sample",
        "R = rotations.exp_so3(-(a * axis))": "another sample",
        "for a in (0.0, 0.001, 0.5, -2.0, 3.0, np.pi):": "another sample",
        "for a in (0.0, 0.001, 0.5, 2.0, -3.0, np.pi):": "another sample",
        "for a in (0.0, 0.001, 0.5, 2.0, 3.0, -np.pi):": "another sample",
        "for a in (0.0, 0.001, 0.5, 2.2, 3.0, np.pi):": "another sample",
        "for a in (0.0, 0.001, 0.55, 2.0, 3.0, np.pi):": "another sample",
        "for a in (0.0, 0.0011, 0.5, 2.0, 3.0, np.pi):": "another sample",
        "for axis in np.array([[1.0, 0, 0], [0, -0.6, -0.8], [-0.48, 0.6, 0.64]]):": "another sample",
        "for axis in np.array([[1.0, 0, 0], [0, 0.6, -0.8], [-0.48, 0.6, -0.64]]):": "another sample",
        "for axis in np.array([[1.0, 0, 0], [0, 0.6, -0.8], [-0.48, 0.6, 0.7040000000000001]]):": "another sample",
        "for axis in np.array([[1.0, 0, 0], [0, 0.6, -0.8], [-0.48, 0.66, 0.64]]):": "another sample",
        "for axis in np.array([[1.0, 0, 0], [0, 0.6, -0.8], [-0.528, 0.6, 0.64]]):": "another sample",
        "for axis in np.array([[1.0, 0, 0], [0, 0.6, -0.8], [0.48, 0.6, 0.64]]):": "another sample",
        "for axis in np.array([[1.0, 0, 0], [0, 0.6, 0.8], [-0.48, 0.6, 0.64]]):": "another sample",
        "for axis in np.array([[1.0, 0, 0], [1, 0.6, -0.8], [-0.48, 0.6, 0.64]]):": "another sample",
        "for axis in np.array([[1.0, 1, 0], [0, 0.6, -0.8], [-0.48, 0.6, 0.64]]):": "another sample",
        "for axis in np.array([[1.1, 0, 0], [0, 0.6, -0.8], [-0.48, 0.6, 0.64]]):": "another sample",
        "for axis in np.array([[2.0, 0, 0], [0, 0.6, -0.8], [-0.48, 0.6, 0.64]]):": "another sample",
        "if not np.allclose(R, rotations.exp_so3(w), rtol=0, atol=1e-06):": "order",
        "if not np.allclose(rotations.exp_so3(w), R, rtol=0, atol=1.1e-06):": "another sample",
        "if np.linalg.norm(w) >= np.pi + 1e-06:": "bound",
    },
    "log_so3": {
        "if sine <= 1e-08 and cosine < 0:": "bound",
        "longest = columns[:, np.linalg.norm(columns, axis=1).argmax()]": "half turn",
        "longest = columns[np.linalg.norm(columns, axis=0).argmax(), :]": "half turn",
        "longest = columns[np.linalg.norm(columns, axis=0).argmax(),]": "half turn",
        "return -(np.pi * longest / np.linalg.norm(longest))": "half turn",
        "return s if sine <= 1e-08 else np.arctan2(sine, cosine) / sine * s": "bound",
    },
    "euler_angles": {
        "cosine = np.hypot(-R[0, 0], R[1, 0])": "sign",
        "cosine = np.hypot(R[1, 0], R[0, 0])": "order",
        "if cosine < 1.1000000000000001e-08:": "bound",
        "if cosine <= 1e-08:": "bound",
    },
    "quaternion_product": {
        "scalar = p[0] * q[0] - q[1:] @ p[1:]": "order",
    },
    "quaternion_to_matrix": {
        "return np.eye(3) + 2 * q[0] * V + V @ (2 * V)": "order",
    },
    "slerp": {
        "if phi < 1.1e-06:": "bound",
        "if phi <= 1e-06:": "bound",
        "if q0 @ q1 <= 0:": "bound",
        "if q1 @ q0 < 0:": "order",
        "phi = np.arccos(min(1.0, q0 @ q1))": "order",
        "phi = np.arccos(min(q1 @ q0, 1.0))": "order",
        "return -((1 - t) * q0 + t * q1)": "either sign",
        "return -((np.sin((1 - t) * phi) * q0 + np.sin(t * phi) * q1) / np.sin(phi))": "either sign",
    },
    "nearest_so": {
        "signs[-1] = np.linalg.det(U @ Vt.T)": "transposed",
        "signs[-1] = np.linalg.det(U.T @ Vt)": "transposed",
        "signs[-1] = np.linalg.det(Vt @ U)": "transposed",
    },
    "is_valid": {
        "error = np.abs(np.eye(len(X)) - X.T @ X).max()": "transposed",
        "if X.shape not in ((4, 4), (3, 3)):": "order",
        "return X.shape in ((4, 1), (4,)) and abs(np.linalg.norm(X) - 1) <= tol": "order",
        "return X.shape in ((4,), (4, 1)) and abs(np.linalg.norm(X) - 1) < tol": "touching",
        "return is_valid(X[:-1, :-1], 'rotation', tol) and row_error < tol": "touching",
        "row_error = np.abs(X[-1] - np.eye(len(X.T))[-1]).max()": "transposed",
    },
    "random_rotations_euler": {
        "alpha, gamma = -(2 * np.pi * rng.random((2, n)))": "distribution",
        "alpha, gamma = -2 * np.pi * rng.random((2, n))": "distribution",
        "return rot_z(-gamma) @ rot_y(beta) @ rot_x(alpha)": "distribution",
        "return rot_z(gamma) @ rot_y(beta) @ rot_x(-alpha)": "distribution",
    },
    "random_rotations": {
        "... ck([np.cos(phi) * np.sqrt(z), -(np.sin(phi) * np.sqrt(z)), np.sqrt(1 - ...": "distribution",
        "theta, phi = -(2 * np.pi * rng.random((2, n)))": "distribution",
    },
    "random_quaternions": {
        "... 1, np.cos(theta_1) * sigma_1, -(np.sin(theta_2) * sigma_2)], axis=-1) ...": "same place",
        "... os(theta_2) * sigma_2, np.sin(-theta_1) * sigma_1, np.cos(theta_1) * s ...": "distribution",
        "... return np.stack([np.cos(-theta_2) * sigma_2, np.sin(theta_1) * s ...": "distribution",
        "sigma_1, sigma_2 = (np.sqrt(s), np.sqrt(1 - s))": "distribution",
        "theta_1, theta_2 = -(2 * np.pi * rng.random((2, n)))": "distribution",
        "theta_1, theta_2 = -2 * np.pi * rng.random((2, n))": "distribution",
    },
    "test_wrap_angle": {
        "angles = -np.random.default_rng(0).uniform(-70, 70, 300)": "free choice",
        "same = -np.allclose(np.exp(1j * values), np.exp(1j * angles), rtol=0, atol=1e-09)": "unasked",
        "angles = np.random.default_rng(1).uniform(-70, 70, 300)": "free choice",
        "angles = np.random.default_rng(0).uniform(-77.0, 70, 300)": "free choice",
        "angles = np.random.default_rng(0).uniform(-70, 77.0, 300)": "free choice",
        "... p(1j * angles), rtol=0, atol=1.1000000000000001e-09) ...": "rounding",
        "same = np.allclose(np.exp(1j * angles), np.exp(1j * values), rtol=0, atol=1e-09)": "order",
        "return same and np.abs(values).max() < np.pi": "bound",
    },
    "step_lengths": {
        "lengths.append(min(remaining, dt))": "order",
        "while remaining >= 1e-09:": "bound",
        "while remaining > 1.1000000000000001e-09:": "rounding",
    },
    "exp_se2": {
        "c, s = (np.cos(-omega), np.sin(omega))": "sign",
        "across = omega / 2 * np.sinc(omega / (-2 * np.pi)) ** 2": "sign",
    },
    "log_se2": {
        "across = omega / 2 * np.sinc(omega / (-2 * np.pi)) ** 2": "sign",
    },
    "two_link_angles": {
        "inside = np.arctan2(np.sin(theta2), 1 + np.cos(-theta2))": "sign",
        "for theta2 in (-bend, bend):": "order",
    },
    "propagate_body_exact": {
        "steps = int(np.ceil(duration / dt - 1.1000000000000001e-09))": "rounding",
    },
    "hat_se3": {
        "matrix = -np.zeros((4, 4))": "sign",
    },
    "exp_se3": {
        "T[:3, :3] += W + W @ W / 2.2": "rounding",
        "T[:3, :3] += W": "rounding",
        "T[:3, :3] += W + W @ W": "rounding",
        "a = -np.linalg.norm(omega)": "sign",
        "if np.abs(omega).max() <= 1e-05:": "bound",
    },
    "adjoint": {
        "return np.block([[R, -np.zeros((3, 3))], [hat(p) @ R, R]])": "sign",
    },
    "forward_kinematics": {
        "for S, angle in zip(q, screws, strict=True):": "order",
    },
    "space_jacobian": {
        "columns.append(adjoint(T) @ S.T)": "vector",
        "T = T @ exp_se3(S.T * angle)": "vector",
    },
    "twist_in_frames": {
        "omega, v = (V_s.T[:3], V_s[3:])": "vector",
        "omega, v = (V_s[:3], V_s.T[3:])": "vector",
        "return np.array([V_s, adjoint(inverse(T)) @ V_s.T, hybrid])": "vector",
        "return np.array([V_s.T, adjoint(inverse(T)) @ V_s, hybrid])": "vector",
    },
    "body_screws": {
        "return np.array([adjoint(inverse(M)) @ S.T for S in screws])": "vector",
    },
    "rotation_about": {
        "R = np.eye(3) + np.sin(theta) * W + W @ ((1 - np.cos(theta)) * W)": "order",
    },
    "first_bad_row": {
        "bad = ~np.isfinite(t) | ~np.isfinite(q).all(axis=-1)": "same place",
        "bad |= ((q < limits[:, 0]) | (q > limits[:, 1])).any(axis=-1)": "same place",
    },
    "lost_direction": {
        "return -np.linalg.svd(J)[0][:, 5]": "either sign",
        "return np.linalg.svd(-J)[0][:, 5]": "either sign",
    },
    "read_iiwa": {
        "... 0, 1, 0, 0, 0], [0, 1, 0, 0, 1, 0.36 + 0.42 + 0.4], [0, 0, 1, 0, 0, 0 ...": "any point",
        "... urn np.array([[0, 0, 1, 0, 0, 1], [0, 1, 0, 0, 0, 0.36], [0, 0, 1, 0, ...": "any point",
    },
    "read_ur5e": {
        "... , 0.1625], [0, -1, 0, -0.425, 1, 0.1625], [0, -1, 0, far, 0, 0.1625], ...": "any point",
        "... urn np.array([[0, 0, 1, 0, 0, 1], [0, -1, 0, 0, 0, 0.1625], [0, -1, 0, ...": "any point",
    },
    "singular_configurations": {
        "return -rows": "any point",
        "rows = -np.tile([0.3, 0.7, -0.4, 1.1, 0.5, 0.9, 0.2], (3, 1))": "any point",
        "rows = np.tile([0.3, -0.7, -0.4, 1.1, 0.5, 0.9, 0.2], (3, 1))": "any point",
        "rows = np.tile([0.3, 0.7, -0.4, -1.1, 0.5, 0.9, 0.2], (3, 1))": "any point",
        "rows = np.tile([0.3, 0.7, -0.4, 1.1, 0.5, -0.9, 0.2], (3, 1))": "any point",
        "rows = np.tile([0.3, 0.7, 0.4, 1.1, 0.5, 0.9, 0.2], (3, 1))": "any point",
        "rows = np.tile([0.33, 0.7, -0.4, 1.1, 0.5, 0.9, 0.2], (3, 1))": "any point",
        "rows[1, 1:3] = (0, -(np.pi / 2))": "any point",
        "rows[1, 1:3] = (0, np.pi / -2)": "any point",
        "rows[2, 4:6] = (-(np.pi / 2), 0)": "any point",
    },
    "wrench_in_space": {
        "return adjoint(inverse(T)).T @ F_b.T": "vector",
    },
    "test_adjoint": {
        "... spose(columns), rtol=0, atol=1.1000000000000001e-09): ...": "rounding",
        "T = rigid.exp_se3(-(np.arange(6) - k))": "any point",
        "T = rigid.exp_se3(k - np.arange(6))": "any point",
        "T = rigid.exp_se3(np.arange(6) + k)": "any point",
        "T = rigid.exp_se3(np.arange(6))": "any point",
        "for k in range(-1, 4):": "any point",
        "for k in range(2, 4):": "any point",
        "if not np.allclose(np.transpose(columns), adjoint(T), rtol=0, atol=1e-09):": "order",
    },
    "test_ik_2r": {
        "... ([1.0, 1.0], [-0.6, 1.3], [-1.2100000000000002, -0.4], [1.999, 0.0], [ ...": "free choice",
        "for xy in ([1.0, -1.0], [-0.6, 1.3], [-1.1, -0.4], [1.999, 0.0], [2.0, 0.0]):": "free choice",
        "for xy in ([1.0, 1.0], [-0.6, 1.3], [-0.4, -1.1], [1.999, 0.0], [2.0, 0.0]):": "free choice",
        "for xy in ([1.0, 1.0], [-0.6, 1.3], [-1.1, -0.4], [-1.999, 0.0], [2.0, 0.0]):": "free choice",
        "for xy in ([1.0, 1.0], [-0.6, 1.3], [-1.1, -0.4], [0.0, 1.999], [2.0, 0.0]):": "free choice",
        "for xy in ([1.0, 1.0], [-0.6, 1.3], [-1.1, -0.4], [1.999, 0.0], [0.0, 2.0]):": "free choice",
        "for xy in ([1.0, 1.0], [-0.6, 1.3], [-1.1, 0.4], [1.999, 0.0], [2.0, 0.0]):": "free choice",
        "for xy in ([1.0, 1.0], [0.6, 1.3], [-1.1, -0.4], [1.999, 0.0], [2.0, 0.0]):": "free choice",
        "for xy in ([1.0, 1.0], [1.3, -0.6], [-1.1, -0.4], [1.999, 0.0], [2.0, 0.0]):": "free choice",
        "in_order = q[0, 1] > -1e-06 and q[1, 1] <= 1e-06": "free choice",
        "in_order = q[0, 1] >= -1e-06 and q[1, 1] < 1e-06": "free choice",
        "leads_there = np.allclose(fk_2r(q), xy, atol=1.1e-06)": "free choice",
        "leads_there = np.allclose(xy, fk_2r(q), atol=1e-06)": "order",
    },
    "predict_square": {
        "q2 = sign * np.sqrt(np.maximum(0, square))": "order",
    },
    "newton_step": {
        "second_link = np.array([-np.sin(both), np.cos(-both)])": "sign",
    },
    "number_distance": {
        "return abs(b - a)": "order",
    },
    "convergence_slope": {
        "return np.polyfit(np.log(sizes), np.log(errors), 1.1)[0]": "same place",
    },
    "dh_symbolic": {
        "c, s = (sp.cos(-theta), sp.sin(theta))": "sign",
    },
    "fk_2r": {
        "return np.stack([np.cos(first) + np.cos(-both), np.sin(first) + np.sin(both)], -1)": "sign",
        "first, both = (q[..., 0] + q[..., 1], q[..., 0])": "order",
    },
    "ik_2r": {
        "if cosine >= 1 + 1e-12:": "bound",
    },
    "cell_index": {
        "outside = ((xy < low) | (xy > high)).any(axis=-1)": "same place",
        "index[outside] = -1.1": "same place",
    },
    "split_branches": {
        "k_means = KMeans(n_clusters=2, random_state=1).fit(q)": "another cut",
        "if len(q) == 0 or len(np.unique(-q, axis=0)) < 2:": "rows",
        "return -np.zeros(len(q), int)": "sign",
        "if len(np.unique(q, axis=0)) < 2:": "rows",
        "return k_means.labels_ if centres[0, 1] >= centres[1, 1] else 1 - k_means.labels_": "unasked",
        "if len(q) == 1 or len(np.unique(q, axis=0)) < 2:": "rows",
    },
    "fit_cells": {
        "models = -np.full((count, 2, 2, 3), np.nan)": "sign",
        "for k in (1, 0):": "order",
    },
    "predict": {
        "angles[np.asarray(cell) < 0] = -np.nan": "sign",
    },
    "approximation_error": {
        "return np.linalg.norm(np.asarray(xy)[:, None] - fk_2r(angles), axis=-1)": "same place",
        "return np.linalg.norm(fk_2r(angles) - np.asarray(xy)[:, None], axis=-1.1)": "same place",
    },
    "find_signs": {
        "for signs in itertools.product([-1, 1], repeat=len(table)):": "order",
        "worst = max(np.abs(T - pose).max(), worst)": "order",
        "worst = max(worst, np.abs(pose - T).max())": "order",
        "if worst <= least:": "touching",
    },
    "test_pose_error": {
        "random = np.random.default_rng(2)": "free choice",
        "for angle in (-1e-05, 0.3, 2.0, 3.1):": "free choice",
        "for angle in (1e-05, 0.3, -2.0, 3.1):": "free choice",
        "R = T[:3, :3] @ rotations.exp_so3(angle * axis / np.linalg.norm(axis))": "free choice",
        "R = rotations.exp_so3(angle / axis / np.linalg.norm(axis)) @ T[:3, :3]": "free choice",
        "R = rotations.exp_so3(angle * axis * np.linalg.norm(axis)) @ T[:3, :3]": "free choice",
        "if not np.allclose(reached, target, atol=1e-09) or np.linalg.norm(e[3:]) >= np.pi:": "free choice",
    },
    "reached_targets": {
        "e = -ik.pose_error(panda.fk(q), targets)": "sign",
        "q = q0": "same place",
        "q = np.zeros((7,)) + q0": "same place",
        "return (np.linalg.norm(e.reshape(-1, 2, 3), axis=2) <= 0.001).all(axis=1)": "touching",
    },
    "weighted_step": {
        "roots = -np.sqrt(weights)": "sign",
    },
    "follow_velocity": {
        "eps = most * (1 - (s / near) ** 2) if s <= near else 0": "bound",
    },
    "fit_rotation": {
        "return U @ np.diag([1, 1, np.linalg.det(Vt @ U)]) @ Vt": "order",
        "return U @ np.diag([1, 1, np.linalg.det(U.T @ Vt)]) @ Vt": "transposed",
        "return U @ np.diag([1, 1, np.linalg.det(U @ Vt.T)]) @ Vt": "transposed",
        "B = dst.T @ (src - src.mean(0))": "mean",
        "B = (dst - dst.mean(0)).T @ src": "mean",
        "B = (dst + dst.mean(0)).T @ (src - src.mean(0))": "mean",
        "B = (dst - dst.mean(0)).T @ (src + src.mean(0))": "mean",
    },
    "null_space_step": {
        "return q + (q_middle - q) @ (gain * projector)": "transposed",
    },
    "bounded_step": {
        "A = np.vstack([J, -(np.sqrt(eps) * np.eye(n))])": "sign",
        "... bounds=(-bound, bound), tol=1.1000000000000002e-12).x ...": "free choice",
        "return lsq_linear(A, np.append(v, np.zeros(n)), bounds=(-bound, bound), tol=-1e-12).x": "free choice",
    },
    "register_points": {
        "B = (w[:, None] * (dst + c_dst)).T @ (src - c_src)": "mean",
        "B = (w[:, None] * (dst - c_dst)).T @ (src + c_src)": "mean",
        "R = U @ np.diag([1, 1, np.linalg.det(U.T @ Vt)]) @ Vt": "transposed",
        "B = (w[:, None] * dst).T @ (src - c_src)": "mean",
        "B = (w[:, None] * (dst - c_dst)).T @ src": "mean",
    },
    "good_matches": {
        "gaps = -(src @ T[:3, :3].T + T[:3, 3] - dst)": "sign",
        "gaps = dst - (src @ T[:3, :3].T + T[:3, 3])": "order",
        "good = np.linalg.norm(gaps, axis=1.1) < tol": "same place",
        "good = np.linalg.norm(gaps, axis=1) <= tol": "touching",
        "if good.sum() >= best.sum():": "touching",
    },
    "panda_ik": {
        "random = np.random.default_rng(1)": "free choice",
        "if np.linalg.norm(e) <= 1e-07:": "free choice",
        "if np.linalg.norm(e) < 1.1e-07:": "free choice",
        "q = ik_step_dls(q, geometric_jacobian(frames), e, 0.05 * e)": "free choice",
    },
    "grasp_pose": {
        "weights = -np.ones(len(template))": "sign",
    },
    "subproblem1": {
        "p_across = p": "axis part",
        "g_across = g": "axis part",
        "p_across = p - p @ k * k": "order",
        "g_across = g - g @ k * k": "order",
        "return np.arctan2(np.cross(p_across, g_across) @ k, p_across @ g_across)": "order",
        "return np.arctan2(k @ np.cross(p_across, g_across), g_across @ p_across)": "order",
        "p_across = p + k @ p * k": "axis part",
        "g_across = g + k @ g * k": "axis part",
        "p_across = p - k": "axis part",
        "g_across = g - k": "axis part",
    },
    "subproblem2": {
        "if abs(np.linalg.norm(p2) - np.linalg.norm(p1)) > 1e-09:": "order",
        "if abs(np.linalg.norm(p1) - np.linalg.norm(p2)) >= 1e-09:": "bound",
        "if abs(np.linalg.norm(p1) - np.linalg.norm(p2)) > 1.1000000000000001e-09:": "rounding",
        "n = np.cross(k2, k1)": "order",
        "if c_squared <= -1e-09 * (p1 @ p1):": "bound",
        "if c_squared < -1.1000000000000001e-09 * (p1 @ p1):": "rounding",
        "c = np.sqrt(max(0, c_squared))": "order",
    },
    "test_subproblem2": {
        "draw = np.random.default_rng(2)": "any point",
        "k1, k2 = (unit(k2), unit(k1))": "any point",
        "k1, k2 = (-unit(k1), unit(k2))": "any point",
        "k1, k2 = (unit(k1), unit(-k2))": "any point",
        "a, b = draw.uniform(-3.3000000000000003, 3, 2)": "any point",
        "p1, p2 = (rotate(k1, a, z), rotate(-k2, b, z))": "any point",
        "if len(pairs) != 2 or not np.allclose(second, first) or np.allclose(*first):": "order",
        "if len(subproblem2(k1, k2, p1, -2 * p2)) > 0:": "any point",
        "if len(subproblem2(k1, k2, p1, 2 / p2)) > 0:": "any point",
        "far_apart = (-unit([0.1, 0, 1]), unit([1, 0.1, 0]))": "any point",
        "far_apart = (unit([0.1, 0, 2]), unit([1, 0.1, 0]))": "any point",
        "far_apart = (unit([0.1, 0, 1]), unit([-1, 0.1, 0]))": "any point",
    },
    "subproblem3": {
        "if d <= 0:": "touching",
    },
    "arm_angles": {
        "distance = np.linalg.norm(SHOULDER - center)": "order",
    },
    "six_axis_ik": {
        "center = motion[:3, :3] @ WRIST.T + motion[:3, 3]": "vector",
        "for b in euler_yxy(SWAP.T @ W @ SWAP.T):": "symmetric",
        "for b in euler_yxy(SWAP @ W @ SWAP):": "symmetric",
    },
    "step_limit": {
        "largest = -np.linalg.svd(J, compute_uv=False)[0]": "sign",
        "largest = np.linalg.svd(-J, compute_uv=False)[0]": "sign",
    },
    "subproblem4": {
        "if r == 0 or abs(d - constant) >= r:": "touching",
        "swing = -np.arccos((d - constant) / r)": "sign",
        "constant = h @ k * (k @ p)": "order",
        "if abs(d - constant) > r:": "unasked",
    },
    "euler_yxy": {
        "sine = np.hypot(R[2, 1], R[0, 1])": "order",
        "b2 = np.arctan2(sign * sine, R.T[1, 1])": "transposed",
        "b1 = np.arctan2(sign * R[0, 1], sign * R[2, 1])": "unasked",
        "b1 = np.arctan2(sign * R[0, 1], sign * R[2, 1]) if sine >= 0 else 0.0": "unasked",
    },
    "planar_jacobian": {
        "links = np.array([-np.sin(angles), np.cos(-angles)])": "sign",
        "return np.cumsum(links[:, ::-1], axis=-1)[:, ::-1]": "same place",
    },
}

# {exercise: {the changed line: an input that tells the mutant from the solution}}: what the check still lets through.
# {exercise: {the changed line: an input that tells it from the solution}}: what a check should ask, and does not.
HOLES = {}
