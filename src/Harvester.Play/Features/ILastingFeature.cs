namespace Harvester.Play.Features;

/// <summary>A feature that leaves something in the game or a pending write when it stops.</summary>
public interface ILastingFeature : IFeature
{
    /// <summary>Whether its work continues on another thread: a file is being read or written.</summary>
    bool IsBusy { get; }

    /// <summary>
    /// Ends it for good: removes what it left in the game and writes files, within the time that a script may take to end.
    /// </summary>
    void Finish();
}
