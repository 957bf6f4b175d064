namespace Harvester.Play.Features;

/// <summary>A feature that leaves something behind when it stops: in the game, or on its way to the disk.</summary>
public interface ILastingFeature : IFeature
{
    /// <summary>Whether work of it goes on on another thread: a file is being read or written.</summary>
    bool IsBusy { get; }

    /// <summary>Ends it for good: nothing is left in the game, and files are written, as long as a script may take to end.</summary>
    void Finish();
}
