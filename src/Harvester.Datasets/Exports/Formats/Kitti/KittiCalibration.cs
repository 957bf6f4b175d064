using System.Collections.Generic;
using System.Linq;
using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Exports.Formats.Kitti;

/// <summary>
/// KITTI's calibration file for a single camera. All four projection matrices are that camera's, the rectification is the identity, and the
/// laser scanner, which does not exist, is placed at the camera (x forward, y left, z up), as is the inertial unit.
/// </summary>
internal static class KittiCalibration
{
    private static readonly double[] VelodyneToCamera = [0, -1, 0, 0, 0, 0, -1, 0, 1, 0, 0, 0];
    private static readonly double[] NoMotion = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];
    private static readonly double[] NoRotation = [1, 0, 0, 0, 1, 0, 0, 0, 1];

    /// <summary>The lines of a file; the two benchmarks name the last three matrices differently.</summary>
    public static string Text(CameraLabel camera, string rectification, string velodyne, string inertial)
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
            $"{velodyne} {Numbers.Row(0, VelodyneToCamera)}",
            $"{inertial} {Numbers.Row(0, NoMotion)}",
        ];
        return string.Concat(lines.Select(line => line + "\n"));
    }
}
