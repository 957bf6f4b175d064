using Harvester.Sessions.Plans;

namespace Harvester.Runs.Supervising;

/// <summary>The sign of life that a supervised program writes again and again.</summary>
/// <param name="Process">Number of its process.</param>
/// <param name="Time">When it was written, UTC.</param>
/// <param name="State">What the program is doing.</param>
/// <param name="Trial">Name of the trial of a plan that is under way; empty without one.</param>
/// <param name="Frames">Frames so far, 0 or more.</param>
public sealed record SeenHeartbeat(int Process, DateTime Time, HeartbeatState State, string Trial, long Frames);
