using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;
using Harvester.Play.Features;
using Harvester.Play.Settings;
using Harvester.Sessions.Events;
using Harvester.Sessions.Plans;
using Harvester.Sessions.Rigs;

namespace Harvester.Play.Plans;

/// <summary>What to harvest in a trial, and how.</summary>
internal static class TrialOptions
{
    /// <summary>The options of the settings, with what the plan says in their place.</summary>
    /// <param name="options">The options of the settings.</param>
    /// <param name="plan">The plan.</param>
    /// <param name="trial">The trial.</param>
    /// <param name="rig">The rig of the trial's camera; null for a single camera.</param>
    public static HarvestOptions Of(HarvestOptions options, Plan plan, Trial trial, Rig? rig) =>
        GameRig.AppliedTo(
            options with
            {
                Rig = null,
                Image = trial.Camera.Image,
                RateHz = plan.Hz,
                MaxFrames = plan.FramesAt(trial.Place) * (rig?.Cameras.Count ?? 1),
                Events = plan.Events ? options.Events ?? new EventOptions { RateHz = HarvestSettings.EventRateHz } : null,
                Masks = plan.Masks != PlanMasks.Off || options.Semantics is not null,
                MaskMethod = plan.Masks == PlanMasks.Coded ? MaskMethod.Coded : MaskMethod.Rays,
            },
            rig
        );
}
