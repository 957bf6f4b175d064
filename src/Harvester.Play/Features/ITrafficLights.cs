namespace Harvester.Play.Features;

/// <summary>Lets a script drive the game's traffic lights.</summary>
public interface ITrafficLights
{
    /// <summary>Whether a light is in the game.</summary>
    bool Exists(int light);

    /// <summary>Sets the state of a light until the next call.</summary>
    /// <param name="light">The light's handle.</param>
    /// <param name="value">The game's number of a state; 3 gives the light back to the game.</param>
    void Override(int light, int value);
}
