using Harvester.Datasets.Files;
using Harvester.Datasets.Sessions;
using Harvester.Sessions.Files;
using Harvester.Sessions.Scenes;

namespace Harvester.Datasets.Exports;

/// <summary>The scene of a frame that is exported.</summary>
internal static class FrameScene
{
    /// <summary>Reads the scene of a frame; null in a session without scenes.</summary>
    /// <exception cref="DatasetFormatException">The scene is damaged.</exception>
    public static RecordedScene? Read(ExportFrame frame)
    {
        string file = FramePaths.Scene(frame.Label.Frame);
        if (!frame.HasFile(file))
        {
            return null;
        }

        try
        {
            return SceneParser.Read(frame.Session.PathOf(file), frame.Label);
        }
        catch (DatasetFormatException e)
        {
            throw frame.Problem($"its scene '{file}' cannot be read: {e.Message}");
        }
    }
}
