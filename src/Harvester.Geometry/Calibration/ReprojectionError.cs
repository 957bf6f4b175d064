using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Calibration;

/// <summary>The distances between where points are seen and where a camera model projects them.</summary>
/// <param name="RmsPixels">Root mean square distance, pixels.</param>
/// <param name="MaxPixels">Maximum distance, pixels.</param>
/// <param name="Count">The number of points.</param>
public readonly record struct ReprojectionError(double RmsPixels, double MaxPixels, int Count)
{
    /// <summary>The error of a camera model over sightings; all 0 if there are none.</summary>
    /// <exception cref="ArgumentException">A point lies nearer than the near plane.</exception>
    public static ReprojectionError Of(CameraIntrinsics intrinsics, IReadOnlyList<Sighting> sightings)
    {
        Guard.NotNull(intrinsics, nameof(intrinsics));
        Guard.NotNull(sightings, nameof(sightings));
        double sum = 0;
        double largest = 0;
        foreach (Sighting sighting in sightings)
        {
            double distance = Distance(intrinsics, sighting);
            sum += distance * distance;
            largest = Math.Max(largest, distance);
        }

        return sightings.Count == 0 ? default : new ReprojectionError(Math.Sqrt(sum / sightings.Count), largest, sightings.Count);
    }

    /// <summary>The error of one sighting, pixels.</summary>
    internal static double Distance(CameraIntrinsics intrinsics, Sighting sighting)
    {
        Projection projection = new Camera(sighting.CameraPose, intrinsics).Project(sighting.World);
        return projection.Outcome == ProjectionOutcome.BehindNearPlane
            ? throw new ArgumentException("A point that is seen lies behind the camera's near plane.", nameof(sighting))
            : (projection.Pixel - sighting.Pixel).Length;
    }
}
