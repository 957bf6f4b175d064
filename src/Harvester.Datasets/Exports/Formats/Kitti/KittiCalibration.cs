using System.Collections.Generic;
using System.Linq;
using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Exports.Formats.Kitti;

/// <summary>
/// KITTI's calibration for a single camera: all four projection matrices are its own, nothing is rectified, and the laser scanner, which
/// there is none of, would sit in the camera (x forward, y left, z up), with the inertial unit at the same place.
/// </summary>
internal static class KittiCalibration
{
    private static readonly double[] VelodyneToCamera = [0, -1, 0, 0, 0, 0, -1, 0, 1, 0, 0, 0];
    private static readonly double[] NoMotion = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];
    private static readonly double[] NoRotation = [1, 0, 0, 0, 1, 0, 0, 0, 1];

    /// <summary>The lines of a file; the two benchmarks name the last three differently.</summary>
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
