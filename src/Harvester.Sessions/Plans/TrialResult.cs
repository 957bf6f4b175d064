using Harvester.Sessions.Text;

namespace Harvester.Sessions.Plans;

/// <summary>A line of a plan's status file: how an attempt at a trial ended.</summary>
/// <param name="Trial">Id of the trial.</param>
/// <param name="State">How it ended.</param>
/// <param name="Attempt">Number of the attempt, from 1.</param>
/// <param name="Frames">Number of frames of its session; of a failed attempt, those that are deleted, or in the game moved away.</param>
/// <param name="Reason">Why it failed; null if it did not.</param>
public sealed record TrialResult(string Trial, TrialState State, int Attempt, int Frames, string? Reason)
{
    /// <summary>Number of attempts after which a trial is skipped.</summary>
    public const int MaxAttempts = 3;

    private static readonly Dictionary<string, TrialState> States = new(StringComparer.Ordinal)
    {
        ["done"] = TrialState.Done,
        ["failed"] = TrialState.Failed,
        ["skipped"] = TrialState.Skipped,
    };

    /// <summary>Whether the trial needs no further attempt.</summary>
    public bool IsLast => State != TrialState.Failed;

    /// <summary>The result of an attempt that failed; of paths in its reason, the last part remains.</summary>
    public static TrialResult OfFailure(string trial, int attempt, int frames, string reason) =>
        new(trial, attempt < MaxAttempts ? TrialState.Failed : TrialState.Skipped, attempt, frames, PathlessText.Of(reason));

    /// <summary>The line of the file, without a line feed.</summary>
    public string ToJson()
    {
        JsonText json = new JsonText()
            .BeginObject()
            .Key("trial")
            .String(Trial)
            .Key("state")
            .String(JsonName.Of(State))
            .Key("attempt")
            .Integer(Attempt)
            .Key("frames")
            .Integer(Frames);
        return (Reason is null ? json : json.Key("reason").String(Reason)).EndObject().ToString();
    }

    /// <summary>Reads a line of the file.</summary>
    /// <exception cref="FormatException">The line is something else.</exception>
    public static TrialResult Parse(string line)
    {
        CheckedJson fields = CheckedJson.Parse(line, "a plan's status");
        var read = new TrialResult(
            fields.Text("trial"),
            States.TryGetValue(fields.Text("state"), out TrialState state) ? state : throw fields.Wrong("state", "done, failed or skipped"),
            fields.Whole("attempt", 1, MaxAttempts),
            fields.Whole("frames", 0, int.MaxValue),
            fields.Has("reason") ? fields.Text("reason") : null
        );
        fields.End();
        return read;
    }
}
