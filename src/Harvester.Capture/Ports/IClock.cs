namespace Harvester.Capture.Ports;

/// <summary>Real time, independent of the game's time. Used for budgets and rates, never for labels.</summary>
public interface IClock
{
    /// <summary>Milliseconds since an arbitrary moment; never decreases.</summary>
    double Milliseconds { get; }
}
