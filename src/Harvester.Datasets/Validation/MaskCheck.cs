using Harvester.Datasets.Masks;
using Harvester.Datasets.Masks.Pixels;
using Harvester.Geometry;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;

namespace Harvester.Datasets.Validation;

/// <summary>Checks that a mask agrees with its label: every value is an object id, and visible boxes bound the pixels.</summary>
internal static class MaskCheck
{
    private const int MaxNamedNumbers = 5;

    public static IEnumerable<string> Problems(FrameLabel label, InstanceMap map)
    {
        IReadOnlyDictionary<int, InstancePixels> seen = InstancePixels.AllOf(map);
        int[] strays = [.. seen.Keys.Except(label.Objects.Select(item => item.Id)).Order()];
        if (strays.Length > 0)
        {
            yield return $"mask '{label.Mask}' has ids without an object in this line: {Text(strays)}.";
        }

        HashSet<int> listed = [.. label.Objects.Select(item => item.Id)];
        foreach (ObjectLabel part in label.Objects.Where(item => item.Parent is { } parent && listed.Contains(parent)))
        {
            foreach (string problem in PartProblems(part, label, map, seen))
            {
                yield return $"object {part.Id}: {problem}";
            }
        }

        foreach (ObjectLabel item in label.Objects)
        {
            Box2D? bounds = seen.TryGetValue(item.Id, out InstancePixels? pixels) ? pixels.Box : null;
            if (bounds != item.Box2DVisible)
            {
                yield return $"object {item.Id}: box2dVisible is {Text(item.Box2DVisible)}, but the bounds of its pixels in the mask are "
                    + $"{Text(bounds)}.";
            }
            else if (bounds is null && item is { VisibleFraction: > 0, Parent: null })
            {
                yield return FormattableString.Invariant(
                    $"object {item.Id}: visibleFraction is {item.VisibleFraction:0.####}, but it has no pixel in the mask."
                );
            }
        }
    }

    private static IEnumerable<string> PartProblems(
        ObjectLabel part,
        FrameLabel label,
        InstanceMap map,
        IReadOnlyDictionary<int, InstancePixels> seen
    )
    {
        int parent = part.Parent!.Value;
        if (seen.ContainsKey(part.Id))
        {
            yield return $"the mask has its id, but it is a part; pixels of parts have the id of the whole object, {parent}.";
        }

        if (part.VisibleFraction > 0 && !seen.ContainsKey(parent))
        {
            yield return FormattableString.Invariant(
                $"visibleFraction is {part.VisibleFraction:0.####}, but its whole object, {parent}, has no pixel in the mask."
            );
        }

        // Rays show whether a part is hidden by the rest of its object. A map does not, so the pixels of the object there count as the
        // part's.
        if (
            part is { OcclusionMethod: OcclusionMethod.Imported, OccludedFraction: 1 }
            && new CuboidPixels(LabelCamera.Of(label.Camera), part).Shows(map, parent)
        )
        {
            yield return $"occludedFraction is 1, but the mask shows its whole object, {parent}, in its place.";
        }
    }

    /// <summary>Checks a label without a mask.</summary>
    public static IEnumerable<string> ProblemsWithoutMask(FrameLabel label)
    {
        if (label.PixelMap is not null)
        {
            yield return "pixelMap is given without a mask.";
        }

        foreach (ObjectLabel item in label.Objects.Where(item => item.Box2DVisible is not null))
        {
            yield return $"object {item.Id}: box2dVisible is given without a mask.";
        }
    }

    private static string Text(int[] numbers) =>
        string.Join(", ", numbers.Take(MaxNamedNumbers))
        + (numbers.Length > MaxNamedNumbers ? $" and {numbers.Length - MaxNamedNumbers} more" : "");

    private static string Text(Box2D? box) => box is { } some ? ObjectCheck.Text(some) : "null";
}
