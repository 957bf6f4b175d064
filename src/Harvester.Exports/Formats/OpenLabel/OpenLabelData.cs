using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.OpenLabel;

/// <summary>Checks the data of a frame: transforms, boxes, cuboids and lines.</summary>
internal static class OpenLabelData
{
    private const double RoundingPixels = 0.002;

    /// <summary>Elements of quaternions have nine decimals.</summary>
    private const double RoundingUnit = 0.00000001;

    private const int CuboidNumbers = 10;
    private const int MinLineNumbers = 4;

    /// <summary>The problem of the transforms of a frame.</summary>
    public static string? TransformProblem(JsonFields transforms) =>
        transforms
            .Names.Select(name =>
            {
                JsonFields transform = transforms.Fields(name);
                JsonFields data = transform.Fields("transform_src_to_dst");
                _ = data.Vector("translation");
                return transform.Text("dst") != OpenLabelStream.World
                    || transform.Text("src") is not (OpenLabelStream.Ego or OpenLabelStream.Camera)
                        ? $"{name} is not a transform to {OpenLabelStream.World}."
                    : IsUnit(data.Numbers("quaternion", 4)) ? null
                    : $"the quaternion of {name} is not of length 1.";
            })
            .FirstOrDefault(problem => problem is not null);

    /// <summary>The problem of the data of an object.</summary>
    /// <param name="data">The data.</param>
    /// <param name="size">Size of the image; null if unknown.</param>
    /// <param name="boxes">The kind of the boxes.</param>
    public static string? Problem(JsonFields data, ImageSize? size, BoxKind? boxes) =>
        Each(data, "bbox", box => BoxProblem(box, boxes == BoxKind.Amodal ? null : size))
        ?? Each(data, "cuboid", CuboidProblem)
        ?? Each(data, "poly2d", line => LineProblem(line, size));

    private static string? Each(JsonFields data, string kind, Func<JsonFields, string?> problemOf)
    {
        var names = new HashSet<string>(StringComparer.Ordinal);
        return !data.Has(kind)
            ? null
            : data.List(kind)
                .Select(item =>
                    names.Add(item.Text("name")) ? problemOf(item) : $"two items of {kind} have the name '{item.Text("name")}'."
                )
                .FirstOrDefault(problem => problem is not null);
    }

    private static string? BoxProblem(JsonFields item, ImageSize? size)
    {
        double[] val = item.Numbers("val", 4);
        var box = new Box2D(val[0] - (val[2] / 2), val[1] - (val[3] / 2), val[0] + (val[2] / 2), val[1] + (val[3] / 2));
        return !(box.Width > 0 && box.Height > 0) ? "its bbox has no area."
            : size is { } image && !image.Bounds.Contains(box, RoundingPixels)
                ? $"its bbox does not lie in the image of {image.Width} x {image.Height}."
            : null;
    }

    private static string? CuboidProblem(JsonFields item)
    {
        double[] val = item.Numbers("val", CuboidNumbers);
        return !IsUnit(val[3..7]) ? "the quaternion of its cuboid is not of length 1."
            : val[7..].Any(length => length < 0) ? "a length of its cuboid is negative."
            : item.Text("coordinate_system") != OpenLabelStream.World ? $"its cuboid is not in {OpenLabelStream.World}."
            : null;
    }

    private static string? LineProblem(JsonFields item, ImageSize? size)
    {
        double[] val = item.Numbers("val");
        return val.Length < MinLineNumbers || val.Length % 2 != 0 ? "a line does not have two points or more."
            : item.Boolean("closed") || item.Text("mode") != "MODE_POLY2D_ABSOLUTE" ? "a line is closed, or its mode is unknown."
            : size is { } image
            && val.Chunk(2).Any(point => !image.Bounds.Contains(new Box2D(point[0], point[1], point[0], point[1]), RoundingPixels))
                ? $"a point of a line does not lie in the image of {image.Width} x {image.Height}."
            : null;
    }

    private static bool IsUnit(double[] quaternion) => Math.Abs(quaternion.Sum(part => part * part) - 1) <= RoundingUnit;
}
