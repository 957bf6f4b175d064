using Harvester.Exports.Formats;
using Harvester.Sessions.Reading;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests;

/// <summary>The simulated session with what a format needs.</summary>
internal static class SessionForFormat
{
    /// <summary>Opens the session, or the same with class maps for a format that needs them.</summary>
    public static SessionReader OpenFor(this SimulatedSession session, string format) =>
        DatasetFormats.Find(format)!.NeedsClassMaps ? session.OpenWithClassMaps() : session.Open();
}
