using System.Globalization;
using Harvester.Sessions.Files;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Plans;

/// <summary>A sign of life of a program that runs a plan.</summary>
/// <param name="Process">Number of its process.</param>
/// <param name="Utc">When it was given, UTC.</param>
/// <param name="State">Its state.</param>
/// <param name="Plan">Name of the plan.</param>
/// <param name="Trial">Id of the trial under way; null for none.</param>
/// <param name="Frames">Number of frames so far, of all trials of this run.</param>
public sealed record Heartbeat(int Process, DateTime Utc, HeartbeatState State, string Plan, string? Trial, int Frames)
{
    /// <summary>Name of the file of a whole run or of a shard, in the folder of the plan's output.</summary>
    public static string FileNameOf(Shard shard) =>
        shard.Count == 1 ? "heartbeat.json" : FormattableString.Invariant($"heartbeat-{shard.Number}-of-{shard.Count}.json");

    /// <summary>The content of the file.</summary>
    public string ToJson() =>
        new JsonText()
            .BeginObject()
            .Key("process")
            .Integer(Process)
            .Key("time")
            .String(Utc.ToString("yyyy-MM-ddTHH:mm:ss.fffZ", CultureInfo.InvariantCulture))
            .Key("state")
            .String(JsonName.Of(State))
            .Key("plan")
            .String(Plan)
            .Key("trial")
            .String(Trial)
            .Key("frames")
            .Integer(Frames)
            .EndObject() + "\n";
}
