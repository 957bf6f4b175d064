using System.IO;
using Harvester.Datasets.Files;
using Harvester.Datasets.Sessions;
using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Validation;

/// <summary>The scenes of a session that keeps them: every frame has one, and it can be read.</summary>
internal sealed class SceneCheck(SessionReader session, SessionInfo? info)
{
    // Sessions of earlier versions do not say whether they keep scenes.
    private readonly bool _keepsScenes = info?.KeepsScenes ?? Directory.Exists(session.PathOf(FramePaths.Scenes));

    /// <summary>What is wrong with a frame's scene; null for nothing.</summary>
    public string? Problem(FrameLabel label)
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
            return null;
        }
        catch (DatasetFormatException e)
        {
            return $"scene '{name}' cannot be used: {e.Message}";
        }
    }
}
