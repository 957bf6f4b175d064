using System.Globalization;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Validation;

/// <summary>Checks single objects of a frame.</summary>
internal static class ObjectCheck
{
    /// <summary>Tolerance of pixels, above their rounding in files.</summary>
    internal const double RoundingPixels = 0.01;

    /// <summary>Boxes of visible pixels run along pixel borders and may extend beyond the exact box by less than a pixel.</summary>
    private const double PixelBorder = 1;

    /// <summary>Tolerance of distances, which are rounded to centimetres or better.</summary>
    private const double RoundingMetres = 0.01;

    private const int MaxId = ushort.MaxValue;

    public static IEnumerable<string> Problems(ObjectLabel item, FrameLabel frame)
    {
        CameraLabel camera = frame.Camera;
        var image = new Box2D(0, 0, camera.Width, camera.Height);
        if (item.Id is < 1 or > MaxId)
        {
            yield return $"an object has the id {item.Id}; ids are 1 to {MaxId}.";
        }

        foreach ((string name, Box2D box) in Boxes(item))
        {
            if (!(box.Width > 0 && box.Height > 0))
            {
                yield return Of(item, $"{name} {Text(box)} has no area.");
            }
        }

        if (!image.Contains(item.Box2D, RoundingPixels))
        {
            yield return Of(item, $"box2d {Text(item.Box2D)} does not lie in the image of {camera.Width} x {camera.Height}.");
        }

        if (!item.Box2DAmodal.Contains(item.Box2D, RoundingPixels))
        {
            yield return Of(item, $"box2d {Text(item.Box2D)} does not lie within box2dAmodal {Text(item.Box2DAmodal)}.");
        }

        // An imported mask, which has no pixelMap, may show an object beyond its cuboid, and so may one from photographs.
        if (frame.PixelMap is { Pictures: null } && item.Box2DVisible is { } visible && !item.Box2D.Contains(visible, PixelBorder))
        {
            yield return Of(item, $"box2dVisible {Text(visible)} does not lie within box2d {Text(item.Box2D)}.");
        }

        if (item.AmodalMask?.ProblemIn(new ImageSize(camera.Width, camera.Height)) is { } unfit)
        {
            yield return Of(item, unfit);
        }

        if (item is { Box2DWhole: { } whole, Box2DVisible: { } seen } && !whole.Contains(seen, RoundingPixels))
        {
            yield return Of(item, $"box2dVisible {Text(seen)} does not lie within box2dWhole {Text(whole)}.");
        }

        if (item.TruncatedFraction is < 0 or > 1)
        {
            yield return Of(item, FormattableString.Invariant($"truncatedFraction is {item.TruncatedFraction}; it must be 0 to 1."));
        }

        if (item.OccludedFraction is < 0 or > 1)
        {
            yield return Of(item, FormattableString.Invariant($"occludedFraction is {item.OccludedFraction}; it must be 0 to 1."));
        }

        if (item.TrueOccludedFraction is < 0 or > 1)
        {
            yield return Of(item, FormattableString.Invariant($"trueOccludedFraction is {item.TrueOccludedFraction}; it must be 0 to 1."));
        }

        double distance = (item.Box3D.Centre - camera.Pose.Position).Length;
        if (Math.Abs(item.DistanceMetres - distance) > RoundingMetres)
        {
            yield return Of(
                item,
                FormattableString.Invariant(
                    $"distanceMetres is {item.DistanceMetres}, but box3d.centre is {distance:0.###} m from the camera."
                )
            );
        }

        foreach (
            string problem in FaceCheck.Problems(item).Concat(JointsCheck.Problems(item, camera)).Concat(RiderCheck.Problems(item, frame))
        )
        {
            yield return Of(item, problem);
        }
    }

    /// <summary>A box as text.</summary>
    internal static string Text(Box2D box) =>
        string.Create(CultureInfo.InvariantCulture, $"[{box.XMin:0.##}, {box.YMin:0.##}, {box.XMax:0.##}, {box.YMax:0.##}]");

    private static IEnumerable<(string Name, Box2D Box)> Boxes(ObjectLabel item)
    {
        yield return ("box2d", item.Box2D);
        yield return ("box2dAmodal", item.Box2DAmodal);
        if (item.Box2DVisible is { } visible)
        {
            yield return ("box2dVisible", visible);
        }

        if (item.Box2DWhole is { } whole)
        {
            yield return ("box2dWhole", whole);
        }
    }

    private static string Of(ObjectLabel item, string message) => $"object {item.Id}: {message}";
}
