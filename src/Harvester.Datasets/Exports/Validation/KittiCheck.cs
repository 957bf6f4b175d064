using System.Collections.Generic;
using System.Linq;
using Harvester.Datasets.Validation;
using Harvester.Geometry.Cameras;

namespace Harvester.Datasets.Exports.Validation;

/// <summary>What must hold for the labels of KITTI object detection.</summary>
internal static class KittiCheck
{
    private const int Columns = 15;

    private static readonly string[] Types = ["Car", "Van", "Truck", "Pedestrian", "Person_sitting", "Cyclist", "Tram", "Misc", "DontCare"];

    public static IEnumerable<SessionProblem> Problems(string folder) => LabelFiles.Problems(folder, "training/image_2", "training/label_2", ProblemOf);

    private static string? ProblemOf(string[] words, ImageSize image)
    {
        if (words.Length != Columns)
        {
            return $"it has {words.Length} columns instead of {Columns}.";
        }

        if (!Types.Contains(words[0]))
        {
            return $"'{words[0]}' is not a type of KITTI.";
        }

        if (LabelFiles.Numbers(words.Skip(1)) is not { } n)
        {
            return "a column after the type is not a number.";
        }

        // After the type: truncated, occluded, alpha, left, top, right, bottom.
        bool isBox = n[3] >= 0 && n[4] >= 0 && n[3] < n[5] && n[4] < n[6] && n[5] <= image.Width - 1 && n[6] <= image.Height - 1;
        return n[0] is < 0 or > 1 ? "truncated is not 0 to 1."
            : n[1] is not (0 or 1 or 2 or 3) ? "occluded is not 0, 1, 2 or 3."
            : isBox ? null : $"its box does not lie in the image of {image.Width} x {image.Height}.";
    }
}
