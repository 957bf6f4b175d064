namespace Harvester.Driving.Controllers;

/// <summary>
/// Decides whether the neighbouring lane has been free long enough to move there: no vehicle nearer than 20 m for a number of frames in a
/// row.
/// </summary>
internal sealed class LaneClearance
{
    private const double OccupiedWithinMetres = 20;
    private double _previousDistance = 75;
    private int _framesFree;

    public bool IsClear(int framesNeeded) => _framesFree >= framesNeeded;

    /// <summary>Adds the distance of one frame; a single near reading between far ones counts as noise.</summary>
    public void Observe(double distance)
    {
        bool isOccupied = _previousDistance < OccupiedWithinMetres && distance < OccupiedWithinMetres;
        _framesFree = isOccupied ? 0 : _framesFree + 1;
        _previousDistance = distance;
    }

    public void Restart(int framesFree) => _framesFree = framesFree;
}
