using Harvester.Exports.Assembly;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Terminals;

/// <summary>Summarises a finished dataset in one line.</summary>
internal static class ExportSummary
{
    public static string Of(string folder, ExportResult result)
    {
        string splits = string.Join(", ", result.FramesOfSplits.Select(split => $"{split.Key} {split.Value}"));
        string objects = result.Format.HasObjects ? $", {result.Objects} of {Counted.Of(result.Labels, "label")} written" : "";
        string ignored = result.Ignored > 0 ? $", {Counted.Of(result.Ignored, "region")} marked as ignored" : "";
        string lacks =
            result.Format.NeedsFlow ? "flow"
            : result.Format.LeavesOutUnknownLanes ? "known lanes"
            : "points";
        string leftOut = result.FramesLeftOut > 0 ? $"; {Counted.Of(result.FramesLeftOut, "frame")} without {lacks} left out" : "";
        string kind = result.Format.HasPoles ? "written as poles: posts" : "not written: posts";
        string posts = result.Posts > 0 ? $"; {result.Posts} of {Counted.Of(result.Labels, "label")} {kind}" : "";
        return $"{folder}: {result.Format.Name}, {Counted.Of(result.Frames, "frame")} ({splits}){objects}{ignored}{posts}{leftOut}";
    }
}
