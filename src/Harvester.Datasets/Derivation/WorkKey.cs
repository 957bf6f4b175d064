using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;

namespace Harvester.Datasets.Derivation;

/// <summary>
/// A key of what a session is derived from and how. Two runs with the same key write the same bytes, so that one may continue the other.
/// </summary>
internal static class WorkKey
{
    /// <summary>The key of work on sessions, one line.</summary>
    /// <param name="sessions">The sessions.</param>
    /// <param name="options">What is done with them.</param>
    /// <exception cref="IOException">A session cannot be read.</exception>
    public static string Of(IEnumerable<SessionReader> sessions, IEnumerable<string> options) =>
        FileDigest
            .Of(
                string.Join(
                    '\n',
                    sessions.SelectMany(ContentOf).Concat(options).Prepend(typeof(WorkKey).Assembly.GetName().Version!.ToString())
                )
            )
            .Sha256;

    // The manifest has the checksums of all other files, and is shorter than the labels.
    private static IEnumerable<string> ContentOf(SessionReader session) =>
        new[]
        {
            SessionInfo.FileName,
            File.Exists(session.PathOf(Manifest.FileName)) ? Manifest.FileName : SessionReader.LabelsFile,
        }.Select(name => FileDigest.OfFile(session.PathOf(name)).Sha256);
}
