using Harvester.Sessions.Files;

namespace Harvester.Sessions.Reading;

/// <summary>What the manifest of a session says of a frame.</summary>
/// <param name="Frame">Number of the frame.</param>
/// <param name="Label">Digest of its label line, without the line feed.</param>
/// <param name="Files">Digests of its files, by their paths within the session.</param>
public sealed record ManifestFrame(int Frame, FileDigest Label, IReadOnlyDictionary<string, FileDigest> Files);
