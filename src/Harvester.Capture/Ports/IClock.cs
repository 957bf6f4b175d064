namespace Harvester.Capture.Ports;

/// <summary>The time that passes for the player, whatever the game's time does. It serves budgets and rates, never labels.</summary>
public interface IClock
{
    /// <summary>Milliseconds since some moment; never less than before.</summary>
    double Milliseconds { get; }
}
