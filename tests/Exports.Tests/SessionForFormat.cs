using Harvester.Exports.Formats;
using Harvester.Sessions.Reading;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests;

/// <summary>The simulated session with what a format needs.</summary>
internal static class SessionForFormat
{
    /// <summary>Opens the session, or the same with class maps or roads for a format that needs them.</summary>
    public static SessionReader OpenFor(this SimulatedSession session, string format) =>
        DatasetFormats.Find(format)! switch
        {
            { NeedsClassMaps: true } => session.OpenWithClassMaps(),
            { NeedsFlow: true } or { NeedsImu: true } => session.OpenWithFlow(),
            { NeedsOccupancy: true } => session.OpenWithVoxels(),
            { HasMap: true } => session.OpenWithRoads(),
            _ => session.Open(),
        };
}
