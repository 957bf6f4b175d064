using Harvester.Sessions.Reading;

namespace Harvester.Exports.Checks;

/// <summary>Label files as text: one file per image, one line per object, words separated by blanks.</summary>
internal static class LabelFiles
{
    /// <summary>Checks every line of a label file.</summary>
    /// <param name="dataset">The dataset.</param>
    /// <param name="name">The file.</param>
    /// <param name="problemOf">The problem of a line, given its words and its number from 1; null for none.</param>
    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset, string name, Func<int, string[], string?> problemOf)
    {
        if (!dataset.Has(name))
        {
            yield return new SessionProblem(name, null, "it is missing, but its image exists.");
        }

        foreach ((int number, string text) in dataset.Lines(name))
        {
            if (problemOf(number, text.Split(' ')) is { } problem)
            {
                yield return new SessionProblem(name, number, problem);
            }
        }
    }

    /// <summary>Files of a folder that belong to no image.</summary>
    /// <param name="dataset">The dataset.</param>
    /// <param name="folder">The folder.</param>
    /// <param name="stems">Names of the images without their extensions.</param>
    public static IEnumerable<SessionProblem> Strays(DatasetContent dataset, string folder, IEnumerable<string> stems)
    {
        HashSet<string> known = [.. stems];
        return dataset
            .Files(folder)
            .Where(name => !known.Contains(Path.GetFileNameWithoutExtension(name)))
            .Select(name => new SessionProblem(name, null, "its image is missing."));
    }
}
