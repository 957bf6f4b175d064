using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Formats.Mcap;

/// <summary>Checks MCAP datasets: records are complete, checksums are right, and every index leads to what it names.</summary>
internal static class McapCheck
{
    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset)
    {
        foreach (string split in dataset.Splits)
        {
            foreach (string name in dataset.Files(split).Where(name => Path.GetExtension(name) == ".mcap"))
            {
                string? problem = null;
                try
                {
                    using FileStream file = InputFile.OpenRead(dataset.PathOf(name));
                    dataset.Found(split, new McapReader(file).CountImages());
                }
                catch (DatasetFormatException e)
                {
                    problem = e.Message;
                }
                catch (EndOfStreamException)
                {
                    problem = "it is cut off.";
                }

                if (problem is not null)
                {
                    yield return new SessionProblem(name, null, problem);
                }
            }
        }
    }
}
