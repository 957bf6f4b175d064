namespace Harvester.Runs.Ports;

/// <summary>Receives what a run reports while it is under way. A run prints nothing itself.</summary>
public interface IRunLog
{
    /// <summary>Something that happened as intended.</summary>
    /// <param name="line">One line; it may quote files and clients, and with them control characters.</param>
    void Note(string line);

    /// <summary>A problem that does not end the run.</summary>
    /// <param name="message">One sentence or a few; it may quote files and clients.</param>
    void Warn(string message);
}
