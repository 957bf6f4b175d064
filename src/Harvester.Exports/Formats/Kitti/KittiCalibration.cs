namespace Harvester.Exports.Formats.Kitti;

/// <summary>
/// KITTI's calibration file. For a single camera, all four projection matrices are that camera's. The rectification is the identity, and a
/// laser scanner or inertial unit that does not exist is placed at the camera (x forward, y left, z up).
/// </summary>
internal static class KittiCalibration
{
    private static readonly double[] VelodyneToCamera = [0, -1, 0, 0, 0, 0, -1, 0, 1, 0, 0, 0];
    private static readonly double[] NoMotion = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];
    private static readonly double[] NoRotation = [1, 0, 0, 0, 1, 0, 0, 0, 1];

    /// <summary>Stands for the end of a line in <see cref="OdometryText"/>.</summary>
    public const char LineMark = '|';

    /// <summary>The lines of a file of the odometry benchmark, ended by <see cref="LineMark"/>.</summary>
    /// <param name="projections">P0 to P3.</param>
    /// <param name="toCamera">The place of the laser scanner, row by row; null if there is none.</param>
    public static string OdometryText(IEnumerable<double[]> projections, double[]? toCamera) =>
        string.Concat(
            ProjectionLines(projections)
                .Append($"Tr: {Numbers.Row(KittiDecimals.Calibration, toCamera ?? VelodyneToCamera)}")
                .Select(line => line + LineMark)
        );

    /// <summary>The lines of a file; the two benchmarks name the last three matrices differently.</summary>
    /// <param name="projections">P0 to P3.</param>
    /// <param name="toCamera">The place of the laser scanner, row by row; null if there is none.</param>
    /// <param name="rectification">Name of the rectification.</param>
    /// <param name="velodyne">Name of the place of the laser scanner.</param>
    /// <param name="inertial">Name of the place of the inertial unit.</param>
    /// <param name="toVelodyne">The place of the inertial unit beside the laser scanner, row by row; null if there is no scanner.</param>
    public static string Text(
        IEnumerable<double[]> projections,
        double[]? toCamera,
        string rectification,
        string velodyne,
        string inertial,
        double[]? toVelodyne = null
    )
    {
        IEnumerable<string> lines =
        [
            .. ProjectionLines(projections),
            $"{rectification} {Numbers.Row(0, NoRotation)}",
            $"{velodyne} {Numbers.Row(KittiDecimals.Calibration, toCamera ?? VelodyneToCamera)}",
            $"{inertial} {Numbers.Row(KittiDecimals.Calibration, toVelodyne ?? NoMotion)}",
        ];
        return string.Concat(lines.Select(line => line + "\n"));
    }

    private static IEnumerable<string> ProjectionLines(IEnumerable<double[]> projections) =>
        projections.Select((projection, number) => $"P{number}: {Numbers.Row(KittiDecimals.Calibration, projection)}");
}
