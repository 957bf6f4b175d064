using Harvester.Capture.Harvesting;
using Harvester.Play.Features;

namespace Harvester.Play.Plans;

/// <summary>Takes the frames of trials by the mod's own harvest, with the mod's own camera.</summary>
/// <param name="harvest">The harvest.</param>
/// <param name="mount">The camera.</param>
public sealed class TrialHarvest(Harvest harvest, CameraMount mount) : ITrialHarvest
{
    /// <inheritdoc/>
    public bool IsOn => harvest.IsOn;

    /// <inheritdoc/>
    public bool IsBusy => harvest.IsBusy;

    /// <inheritdoc/>
    public int Captured => harvest.Captured;

    /// <inheritdoc/>
    public string? Fault => harvest.LastFault;

    /// <inheritdoc/>
    public bool Begin(string folder, HarvestOptions options, double verticalFovDegrees)
    {
        // The camera is made anew, on the vehicle of the trial and with its field of view.
        mount.Stop();
        mount.VerticalFovDegrees = verticalFovDegrees;
        harvest.StartIn(folder, options);
        return harvest.IsOn;
    }

    /// <inheritdoc/>
    public void End()
    {
        mount.VerticalFovDegrees = null;
        harvest.Stop();
    }
}
