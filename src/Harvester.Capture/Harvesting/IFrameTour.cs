using Harvester.Geometry.Work;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// A tour on which a harvest takes one frame at each of several places, instead of frames at a rate while someone drives. All calls come
/// from the game's own thread; exceptions pass through and end the harvest, which then calls <see cref="Release"/>.
/// </summary>
public interface IFrameTour
{
    /// <summary>Number of places.</summary>
    int Count { get; }

    /// <summary>Brings the camera to a place, and prepares the game for the frame. The game may be frozen at its end.</summary>
    /// <param name="place">Number of the place, from 0.</param>
    /// <returns>The work; <see cref="Obstacle"/> says whether it succeeded.</returns>
    IEnumerable<WorkStep> Approach(int place);

    /// <summary>Why the last place cannot be photographed, as a word for the counts of discarded frames; null if it can.</summary>
    string? Obstacle { get; }

    /// <summary>Gives back what was prepared for a frame.</summary>
    void Leave();

    /// <summary>Gives back everything, also in the middle of a place. Calling it again has no effect.</summary>
    void Release();
}
