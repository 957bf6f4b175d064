using Harvester.Sessions.Reading;

namespace Harvester.Exports.Checks;

/// <summary>Text files that list the content of each split, one name per line. Every name must exist and be in exactly one list.</summary>
internal static class SplitLists
{
    /// <summary>Checks the lists of all splits and counts their frames.</summary>
    /// <param name="dataset">The dataset.</param>
    /// <param name="listOf">Name of the list of a split; a split without frames need not have one.</param>
    /// <param name="framesOf">The number of frames for each name that must be in a list.</param>
    public static IEnumerable<SessionProblem> Problems(
        DatasetContent dataset,
        Func<string, string> listOf,
        IReadOnlyDictionary<string, int> framesOf
    )
    {
        var listed = new HashSet<string>(StringComparer.Ordinal);
        foreach (string split in dataset.Splits)
        {
            string list = listOf(split);
            foreach ((int number, string name) in dataset.Lines(list))
            {
                if (!framesOf.TryGetValue(name, out int frames))
                {
                    yield return new SessionProblem(list, number, $"'{name}' is not in the dataset.");
                }
                else if (!listed.Add(name))
                {
                    yield return new SessionProblem(list, number, $"'{name}' was listed before, here or in another split.");
                }
                else
                {
                    dataset.Found(split, frames);
                }
            }
        }

        foreach (string name in framesOf.Keys.Where(name => !listed.Contains(name)))
        {
            yield return new SessionProblem(listOf("*"), null, $"'{name}' is not in any list.");
        }
    }
}
