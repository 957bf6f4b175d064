using System.Collections.Generic;
using System.Linq;
using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Exports.Formats.Kitti;

/// <summary>
/// KITTI's calibration file for a single camera. All four projection matrices are that camera's, the rectification is the identity, and a
/// laser scanner that does not exist is placed at the camera (x forward, y left, z up), as is the inertial unit.
/// </summary>
internal static class KittiCalibration
{
    private static readonly double[] VelodyneToCamera = [0, -1, 0, 0, 0, 0, -1, 0, 1, 0, 0, 0];
    private static readonly double[] NoMotion = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];
    private static readonly double[] NoRotation = [1, 0, 0, 0, 1, 0, 0, 0, 1];

    /// <summary>The lines of a file; the two benchmarks name the last three matrices differently.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="toCamera">The place of the laser scanner, row by row; null if there is none.</param>
    /// <param name="rectification">Name of the rectification.</param>
    /// <param name="velodyne">Name of the place of the laser scanner.</param>
    /// <param name="inertial">Name of the place of the inertial unit.</param>
    public static string Text(CameraLabel camera, double[]? toCamera, string rectification, string velodyne, string inertial)
    {
        string projection = Numbers.Row(
            KittiDecimals.Calibration,
            camera.Fx, 0, camera.Cx + KittiBox.PixelShift, 0,
            0, camera.Fy, camera.Cy + KittiBox.PixelShift, 0,
            0, 0, 1, 0);
        IEnumerable<string> lines =
        [
            .. Enumerable.Range(0, 4).Select(number => $"P{number}: {projection}"),
            $"{rectification} {Numbers.Row(0, NoRotation)}",
            $"{velodyne} {Numbers.Row(KittiDecimals.Calibration, toCamera ?? VelodyneToCamera)}",
            $"{inertial} {Numbers.Row(0, NoMotion)}",
        ];
        return string.Concat(lines.Select(line => line + "\n"));
    }
}
