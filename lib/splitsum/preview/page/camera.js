// The camera: the twin of preview/camera.cpp. camera.glsl casts its rays.

const radians = Math.PI / 180;

// How far before `across`, the sphere's distance from the axis, a camera whose half field has this
// tangent must stand for the sphere to touch the edge of the picture.
const distanceToSee = (across, radius, tangent) =>
    (across + radius * Math.sqrt(1 + tangent * tangent)) / tangent;

// The middle of the spheres' bounding box, along one axis.
function middleOf(spheres, axis) {
    const low = Math.min(...spheres.map(({ centre, radius }) => centre[axis] - radius));
    const high = Math.max(...spheres.map(({ centre, radius }) => centre[axis] + radius));
    return (low + high) / 2;
}

function cameraFor(spheres, width, height) {
    const margin = 1.04;
    const tanHalfHeight = Math.tan((facts.fieldDegrees / 2) * radians);
    const [x, y] = [middleOf(spheres, 0), middleOf(spheres, 1)];
    const z = Math.min(...spheres.map(({ centre, radius }) => centre[2] - Math.max(
        distanceToSee(Math.abs(centre[0] - x), margin * radius, (tanHalfHeight * width) / height),
        distanceToSee(Math.abs(centre[1] - y), margin * radius, tanHalfHeight))));
    return { tanHalfHeight, position: [x, y, z] };
}

// Column by column, as WebGL takes it: yaw about +y from +z towards +x, then pitch up. Degrees.
function cubeFromView(yaw, pitch) {
    const [cy, sy] = [Math.cos(yaw * radians), Math.sin(yaw * radians)];
    const [cp, sp] = [Math.cos(pitch * radians), Math.sin(pitch * radians)];
    return [cy, 0, -sy, -sy * sp, cp, -cy * sp, sy * cp, sp, cy * cp];
}
