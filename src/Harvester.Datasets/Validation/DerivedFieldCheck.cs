using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Text;

namespace Harvester.Datasets.Validation;

/// <summary>Checks the fields of a line that follow from others, which the label read from it does not have.</summary>
internal static class DerivedFieldCheck
{
    /// <summary>Tolerance of fractions: two of them and their product, each rounded to four decimals, differ by at most 1.5e-4.</summary>
    private const double RoundingFraction = 2e-4;

    /// <summary>Tolerance of angles, which are rounded to four decimals: within it of 90 degrees, either side is accepted.</summary>
    private const double RoundingDegrees = 1e-4;

    /// <param name="label">The label.</param>
    /// <param name="frame">The fields that it was read from.</param>
    public static IReadOnlyList<string> Problems(FrameLabel label, JsonFields frame)
    {
        IReadOnlyList<JsonFields> objects = frame.List("objects");
        var problems = new List<string>();
        for (int i = 0; i < objects.Count; i++)
        {
            try
            {
                problems.AddRange(Problems(label.Objects[i], objects[i]));
            }
            catch (DatasetFormatException e)
            {
                problems.Add(e.Message);
            }
        }

        return problems;
    }

    private static IEnumerable<string> Problems(ObjectLabel item, JsonFields fields)
    {
        double? visible = fields.OptionalNumber("visibleFraction");
        if (visible is null != item.VisibleFraction is null || Math.Abs((visible - item.VisibleFraction) ?? 0) > RoundingFraction)
        {
            yield return $"object {item.Id}: visibleFraction is {Text(visible)}, "
                + $"but (1 - truncatedFraction)(1 - occludedFraction) is {Text(item.VisibleFraction)}.";
        }

        // Labels of earlier versions do not list their boxes.
        string[] boxes = fields.Has("boxes") ? [.. fields.Texts("boxes")] : [.. item.Boxes.Select(JsonName.Of)];
        if (!boxes.SequenceEqual(item.Boxes.Select(JsonName.Of)))
        {
            yield return $"object {item.Id}: boxes is [{string.Join(", ", boxes)}], but the label has "
                + $"[{string.Join(", ", item.Boxes.Select(JsonName.Of))}].";
        }

        if (
            item.Face is { FacingAngleDegrees: >= 0 and <= 180 and var angle }
            && Math.Abs(angle - 90) > RoundingDegrees
            && fields.Fields("space").Boolean("facesCamera") != angle < 90
        )
        {
            yield return FormattableString.Invariant($"object {item.Id}: facesCamera contradicts facingAngleDegrees, which is {angle}.");
        }
    }

    private static string Text(double? fraction) => fraction is { } number ? FormattableString.Invariant($"{number:0.####}") : "null";
}
