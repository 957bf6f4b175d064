using Harvester.Capture.Storage;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Runs.Harvesting;

/// <summary>Recognises the finished session of a harvest that is to be resumed.</summary>
public static class FinishedHarvest
{
    /// <summary>The number of frames of the session; null if the folder has no finished session of this plan.</summary>
    /// <param name="plan">The plan.</param>
    /// <exception cref="DatasetFormatException">The session.json there is malformed.</exception>
    /// <exception cref="IOException">It cannot be read.</exception>
    public static int? FramesIn(HarvestPlan plan)
    {
        string path = Path.Combine(plan.Folder, SessionInfo.FileName);
        if (!File.Exists(path) || UnfinishedMark.CommandIn(plan.Folder) is not null)
        {
            return null;
        }

        int views = plan.Options.ViewsPerMoment;
        int expected = views * Enumerable.Range(0, plan.Frames / views).Count(plan.Options.Shard.Takes);
        SessionInfo info = new SessionReader(plan.Folder).ReadInfo();
        bool isWhole = info.Fault is null && info.CapturedFrames == expected;
        return isWhole && SessionWriter.IsOf(InputFile.ReadAllText(path), SimulatedHarvest.OriginOf(plan), plan.Options) ? expected : null;
    }
}
