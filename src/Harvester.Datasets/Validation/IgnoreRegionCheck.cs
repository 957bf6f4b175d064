using Harvester.Geometry;
using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Validation;

/// <summary>Checks the ignore regions of a frame.</summary>
internal static class IgnoreRegionCheck
{
    public static IEnumerable<string> Problems(FrameLabel label)
    {
        var image = new Box2D(0, 0, label.Camera.Width, label.Camera.Height);
        for (int i = 0; i < label.IgnoreRegions.Count; i++)
        {
            IgnoreRegion region = label.IgnoreRegions[i];
            if (!(region.Box2D.Width > 0 && region.Box2D.Height > 0))
            {
                yield return $"ignoreRegions[{i}]: box2d {ObjectCheck.Text(region.Box2D)} has no area.";
            }

            if (!image.Contains(region.Box2D, ObjectCheck.RoundingPixels))
            {
                yield return $"ignoreRegions[{i}]: box2d {ObjectCheck.Text(region.Box2D)} does not lie in the image of "
                    + $"{label.Camera.Width} x {label.Camera.Height}.";
            }

            if (region.DistanceMetres < 0)
            {
                yield return FormattableString.Invariant(
                    $"ignoreRegions[{i}]: distanceMetres is {region.DistanceMetres}; it must be 0 or more."
                );
            }
        }
    }
}
