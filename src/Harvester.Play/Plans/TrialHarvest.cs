using Harvester.Capture.Harvesting;
using Harvester.Play.Features;

namespace Harvester.Play.Plans;

/// <summary>Takes the frames of trials by the mod's own harvest, with the mod's own camera.</summary>
/// <param name="harvest">The harvest.</param>
/// <param name="mount">The camera.</param>
/// <param name="messages">Reports why a harvest did not begin.</param>
public sealed class TrialHarvest(Harvest harvest, CameraMount mount, PlayerMessages messages) : ITrialHarvest
{
    private bool _isBegun;

    /// <inheritdoc/>
    public bool IsOn => harvest.IsOn;

    /// <inheritdoc/>
    public bool IsBusy => harvest.IsBusy;

    /// <inheritdoc/>
    public int Captured => harvest.Captured;

    /// <inheritdoc/>
    public string? Fault => harvest.LastFault;

    /// <inheritdoc/>
    public bool IsSpaceLow => harvest.IsSpaceLow;

    /// <inheritdoc/>
    public double? RealSecondsPerGameSecond => harvest.RealSecondsPerGameSecond;

    /// <inheritdoc/>
    public bool Begin(string folder, HarvestOptions options, double verticalFovDegrees, KeptScenario? scenario = null)
    {
        if (harvest.IsOn || harvest.IsBusy)
        {
            messages.Tell("Another harvest is running or being written. End it first.");
            return false;
        }

        // The camera is made again, on the vehicle of the trial and with its field of view.
        _isBegun = true;
        mount.Stop();
        mount.VerticalFovDegrees = verticalFovDegrees;
        harvest.StartIn(folder, options, scenario: scenario);
        return harvest.IsOn;
    }

    /// <inheritdoc/>
    public void End()
    {
        // A harvest of the player's own goes on.
        if (!_isBegun)
        {
            return;
        }

        _isBegun = false;
        mount.VerticalFovDegrees = null;
        try
        {
            harvest.Stop();
        }
        finally
        {
            mount.Stop();
        }
    }
}
