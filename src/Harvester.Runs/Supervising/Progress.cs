namespace Harvester.Runs.Supervising;

/// <summary>What has been achieved over all starts. A program that always comes as far as before makes none.</summary>
public sealed class Progress
{
    // A program that invents trials does not fill the memory.
    private const int MaxTrials = 100_000;

    private readonly HashSet<string> _trials = new(StringComparer.Ordinal);
    private bool _isMade;

    /// <summary>The most frames that a heartbeat has had; 0 before the first.</summary>
    public long Frames { get; private set; }

    /// <summary>Takes a heartbeat into account.</summary>
    public void Note(SeenHeartbeat heartbeat)
    {
        bool isNewTrial = heartbeat.Trial.Length > 0 && _trials.Count < MaxTrials && _trials.Add(heartbeat.Trial);
        _isMade |= isNewTrial || heartbeat.Frames > Frames;
        Frames = Math.Max(Frames, heartbeat.Frames);
    }

    /// <summary>Whether there was any since the last call.</summary>
    public bool Take()
    {
        bool isMade = _isMade;
        _isMade = false;
        return isMade;
    }
}
