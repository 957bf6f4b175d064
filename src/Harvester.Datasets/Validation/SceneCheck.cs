using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Datasets.Validation;

/// <summary>Checks the scenes of a session: every frame has one that can be read.</summary>
internal sealed class SceneCheck(SessionReader session, SessionInfo? info)
{
    // Sessions of earlier versions do not record whether they have scenes.
    private readonly bool _keepsScenes = info?.KeepsScenes ?? Directory.Exists(session.PathOf(FramePaths.Scenes));

    /// <summary>The problem of a frame's scene; null for none.</summary>
    /// <param name="label">The frame.</param>
    /// <param name="manifest">The frame's entry in the manifest; null if it has none.</param>
    public string? Problem(FrameLabel label, ManifestFrame? manifest)
    {
        string name = FramePaths.Scene(label.Frame);
        string path = session.PathOf(name);
        if (!_keepsScenes || label.Frame < 0)
        {
            return null;
        }

        if (!File.Exists(path))
        {
            return $"scene '{name}' is missing.";
        }

        try
        {
            _ = SceneParser.Read(path, label);
            return DigestCheck.Problem(path, name, manifest) is { } damage ? $"scene '{name}' {damage}" : null;
        }
        catch (DatasetFormatException e)
        {
            return $"scene '{name}' cannot be used: {e.Message}";
        }
    }
}
