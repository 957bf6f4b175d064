using Harvester.Sessions.Rigs;

namespace Harvester.Play.Plans;

/// <summary>The rig of a plan's camera.</summary>
/// <param name="Rig">The rig.</param>
/// <param name="Text">The text of its file.</param>
internal readonly record struct PlanRig(Rig Rig, string Text);
