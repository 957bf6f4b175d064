using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Harvester.Datasets.Images;
using Harvester.Datasets.Validation;
using Harvester.Geometry.Cameras;

namespace Harvester.Datasets.Exports.Validation;

/// <summary>Text files of labels beside images: one for each image, a line an object, words with blanks between them.</summary>
internal static class LabelFiles
{
    /// <summary>Looks at every line of every label file.</summary>
    /// <param name="folder">The dataset.</param>
    /// <param name="images">Folder of the images within it.</param>
    /// <param name="labels">Folder of the label files within it.</param>
    /// <param name="problemOf">What is wrong with a line in an image of a size; null for nothing.</param>
    public static IEnumerable<SessionProblem> Problems(string folder, string images, string labels, Func<string[], ImageSize, string?> problemOf)
    {
        string imageFolder = Path.Combine(folder, images);
        IEnumerable<string> files = Directory.Exists(imageFolder) ? Directory.EnumerateFiles(imageFolder).Order(StringComparer.Ordinal) : [];
        foreach (string image in files)
        {
            if (SizeOf(image) is not { } size)
            {
                continue;
            }

            string name = $"{labels}/{Path.GetFileNameWithoutExtension(image)}.txt";
            string path = Path.Combine(folder, name);
            if (!File.Exists(path))
            {
                yield return new SessionProblem(name, null, "it is missing, but its image is there.");
                continue;
            }

            int number = 0;
            foreach (string line in File.ReadLines(path))
            {
                number++;
                if (problemOf(line.Split(' '), size) is { } problem)
                {
                    yield return new SessionProblem(name, number, problem);
                }
            }
        }
    }

    /// <summary>The words as finite numbers, or null when one is none.</summary>
    public static double[]? Numbers(IEnumerable<string> words)
    {
        double?[] numbers = [.. words.Select(word =>
            double.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out double number) && double.IsFinite(number) ? number : (double?)null)];
        return numbers.All(number => number is not null) ? [.. numbers.Select(number => number!.Value)] : null;
    }

    /// <summary>The size of an image; null for one that is damaged, which is said elsewhere.</summary>
    private static ImageSize? SizeOf(string image)
    {
        try
        {
            return ImageHeader.Read(image).Size;
        }
        catch (DatasetFormatException)
        {
            return null;
        }
    }
}
