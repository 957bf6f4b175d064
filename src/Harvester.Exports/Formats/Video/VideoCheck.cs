using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Formats.Video;

/// <summary>
/// Checks that every sequence has its video and its label lines. Whether a video is whole is left to the manifest, so that no video
/// decoder reads untrusted files.
/// </summary>
internal static class VideoCheck
{
    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset, bool isLossless)
    {
        foreach (string split in dataset.Splits)
        {
            foreach (string sequence in dataset.Folders(split))
            {
                string labels = $"{sequence}/{VideoWriter.Labels}";
                if (!dataset.Has(labels))
                {
                    yield return new SessionProblem(labels, null, "it is missing.");
                    continue;
                }

                string video = $"{sequence}/{VideoWriter.FramesOf(isLossless)}";
                if (!dataset.Has(video) || new FileInfo(dataset.PathOf(video)).Length == 0)
                {
                    yield return new SessionProblem(video, null, "it is missing or empty.");
                }

                foreach ((int number, string text) in dataset.Lines(labels))
                {
                    dataset.Found(split);
                    if (ProblemOf(text) is { } problem)
                    {
                        yield return new SessionProblem(labels, number, problem);
                    }
                }
            }
        }
    }

    private static string? ProblemOf(string line)
    {
        try
        {
            _ = FrameLabelParser.Parse(line);
            return null;
        }
        catch (DatasetFormatException e)
        {
            return e.Message;
        }
    }
}
