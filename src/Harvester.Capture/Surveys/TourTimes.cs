namespace Harvester.Capture.Surveys;

/// <summary>How long a tour waits at each place, ticks of the game.</summary>
/// <param name="Loading">Most ticks until the ground is loaded; a place without ground is left out.</param>
/// <param name="Standing">Ticks until the vehicle stands still and what is near is drawn in full detail.</param>
/// <param name="Hiding">Ticks until hidden objects leave the picture, in addition to the picture's greatest lag.</param>
public sealed record TourTimes(int Loading, int Standing, int Hiding)
{
    /// <summary>
    /// For the real game: up to 10 s for the ground, as after other teleports; half a second for the vehicle and the finer models; and
    /// twice the ticks after which games have been seen to hide objects.
    /// </summary>
    public static TourTimes OfGame { get; } = new(600, 30, 6);

    /// <summary>For the simulated game, in which everything is there at once.</summary>
    public static TourTimes OfSimulation { get; } = new(2, 2, 2);
}
