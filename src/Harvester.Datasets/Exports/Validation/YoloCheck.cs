using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Harvester.Datasets.Validation;

namespace Harvester.Datasets.Exports.Validation;

/// <summary>What must hold for the labels of Ultralytics YOLO: boxes have four numbers, outlines three corners or more.</summary>
internal static class YoloCheck
{
    private const int BoxNumbers = 4;
    private const int LeastCornerNumbers = 6;

    public static IEnumerable<SessionProblem> Problems(string folder)
    {
        string data = Path.Combine(folder, "data.yaml");
        if (!File.Exists(data))
        {
            return [new SessionProblem("data.yaml", null, "it is missing.")];
        }

        int classes = File.ReadLines(data).Count(line => line.StartsWith("  ", StringComparison.Ordinal));
        string images = Path.Combine(folder, "images");
        return Directory.EnumerateDirectories(images).Order(StringComparer.Ordinal).Select(Path.GetFileName)
            .SelectMany(split => LabelFiles.Problems(folder, $"images/{split}", $"labels/{split}", (words, _) => ProblemOf(words, classes)));
    }

    private static string? ProblemOf(string[] words, int classes)
    {
        if (LabelFiles.Numbers(words) is not { } numbers)
        {
            return "a word is not a number.";
        }

        int places = numbers.Length - 1;
        return places != BoxNumbers && (places < LeastCornerNumbers || places % 2 != 0) ? $"it has {numbers.Length} numbers."
            : !(numbers[0] >= 0 && numbers[0] < classes && numbers[0] == Math.Floor(numbers[0])) ? $"class {words[0]} is none of the {classes} in data.yaml."
            : numbers.Skip(1).Any(number => number is < 0 or > 1) ? "a place is not 0 to 1." : null;
    }
}
