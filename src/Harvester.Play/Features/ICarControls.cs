using Harvester.Geometry;

namespace Harvester.Play.Features;

/// <summary>The game's controls of the player's vehicle, and the environment that a client may set.</summary>
public interface ICarControls
{
    /// <summary>Whether the player now uses any control that drives or leaves a vehicle. Values set here do not count.</summary>
    bool ArePlayers { get; }

    /// <summary>
    /// The controls in force in this frame, whatever set them: steering -1 (left) to 1 (right), throttle, brake and handbrake 0 to 1.
    /// </summary>
    (double Steering, double Throttle, double Brake, double Handbrake) InForce { get; }

    /// <summary>Sets the controls for the next frame, in place of the player's.</summary>
    /// <param name="steering">-1 (left) to 1 (right).</param>
    /// <param name="throttle">0 to 1.</param>
    /// <param name="brake">0 to 1; a standing vehicle reverses by it.</param>
    /// <param name="handbrake">Whether the handbrake is pulled.</param>
    void Set(double steering, double throttle, double brake, bool handbrake);

    /// <summary>Places a vehicle at a position, at rest on the ground.</summary>
    /// <param name="vehicle">The vehicle.</param>
    /// <param name="position">Its origin, metres, world; the height is approximate.</param>
    /// <param name="headingDegrees">Counter-clockwise from north.</param>
    void Place(int vehicle, Vector3D position, double headingDegrees);

    /// <summary>Fixes the weather; null gives it back to the game.</summary>
    /// <param name="weather">One of the game's names, in lower case.</param>
    void KeepWeather(string? weather);

    /// <summary>Sets the time of day, from which it continues.</summary>
    void SetTimeOfDay(TimeSpan timeOfDay);
}
