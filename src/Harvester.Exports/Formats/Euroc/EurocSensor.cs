using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Rigs;

namespace Harvester.Exports.Formats.Euroc;

/// <summary>
/// The descriptions of sensors, lines of sensor.yaml. Bodies have x forward, y left and z up; cameras x right, y down, z forward.
/// </summary>
internal static class EurocSensor
{
    /// <summary>EuRoC counts pixels from the centre of the upper left one, conventions.md from its corner.</summary>
    private const double PixelShift = -0.5;

    private const int Decimals = 9;

    /// <summary>A camera.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="body">The pose of the vehicle.</param>
    /// <param name="rateHz">Images per second; 0 if it is not known.</param>
    public static IEnumerable<string> Camera(CameraLabel camera, Pose body, double rateHz)
    {
        (_, double k1, double k2) = camera.Distortion;
        Axes axes = camera.Pose.Axes;
        return
        [
            "sensor_type: camera",
            "comment: simulated camera",
            .. Place(
                InBody(body, axes.Right),
                InBody(body, -axes.Up),
                InBody(body, axes.Forward),
                InBody(body, camera.Pose.Position - body.Position)
            ),
            $"rate_hz: {Numbers.Row(Decimals, rateHz)}",
            $"resolution: [{Numbers.Text(camera.Width)}, {Numbers.Text(camera.Height)}]",
            "camera_model: pinhole",
            $"intrinsics: [{List(camera.Fx, camera.Fy, camera.Cx + PixelShift, camera.Cy + PixelShift)}]",
            "distortion_model: radial-tangential",
            $"distortion_coefficients: [{List(k1, k2, 0, 0)}]",
        ];
    }

    /// <summary>The inertial unit, which is the body, without its rate.</summary>
    /// <param name="noise">Its noise; null for an ideal unit.</param>
    public static IEnumerable<string> Imu(ImuNoise? noise) =>
        [
            "sensor_type: imu",
            "comment: simulated inertial unit",
            .. Place(new Vector3D(1, 0, 0), new Vector3D(0, 1, 0), new Vector3D(0, 0, 1), Vector3D.Zero),
            $"gyroscope_noise_density: {Numbers.Row(Decimals, noise?.Gyroscope ?? 0)}",
            $"gyroscope_random_walk: {Numbers.Row(Decimals, noise?.GyroscopeWalk ?? 0)}",
            $"accelerometer_noise_density: {Numbers.Row(Decimals, noise?.Accelerometer ?? 0)}",
            $"accelerometer_random_walk: {Numbers.Row(Decimals, noise?.AccelerometerWalk ?? 0)}",
        ];

    /// <summary>A vector of the vehicle's axes right, forward, up in those of EuRoC's body.</summary>
    public static Vector3D InBody(Vector3D local) => new(local.Y, -local.X, local.Z);

    private static Vector3D InBody(Pose body, Vector3D world) => InBody(body.Axes.ToLocal(world));

    private static string List(params ReadOnlySpan<double> values) =>
        Numbers.Row(Decimals, values).Replace(" ", ", ", StringComparison.Ordinal);

    /// <summary>The matrix from the sensor's frame to the body's, from its columns.</summary>
    private static IEnumerable<string> Place(Vector3D x, Vector3D y, Vector3D z, Vector3D origin) =>
        [
            "T_BS:",
            "  cols: 4",
            "  rows: 4",
            $"  data: [{List(x.X, y.X, z.X, origin.X)},",
            $"         {List(x.Y, y.Y, z.Y, origin.Y)},",
            $"         {List(x.Z, y.Z, z.Z, origin.Z)},",
            $"         {List(0, 0, 0, 1)}]",
        ];
}
