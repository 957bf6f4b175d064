using Harvester.Sessions.Reading;

namespace Harvester.Exports.Formats.WebDataset;

/// <summary>Checks WebDataset archives: they are complete, and the files of a sample are consecutive and belong together.</summary>
internal static class WebDatasetCheck
{
    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset)
    {
        var keys = new HashSet<string>(StringComparer.Ordinal);
        foreach (string name in dataset.Files(".").Select(name => Path.GetFileName(name)).Where(name => Path.GetExtension(name) == ".tar"))
        {
            string stem = Path.GetFileNameWithoutExtension(name);
            if (dataset.Splits.FirstOrDefault(split => stem[..Math.Max(0, stem.LastIndexOf('-'))] == split) is not { } split)
            {
                yield return new SessionProblem(name, null, "its name is not that of a split of the export with a number.");
                continue;
            }

            foreach (SessionProblem problem in new SampleArchive(dataset, name, split, keys).Problems())
            {
                yield return problem;
            }
        }
    }
}
