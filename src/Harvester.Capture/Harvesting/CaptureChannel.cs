using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;

namespace Harvester.Capture.Harvesting;

/// <summary>How one channel is produced in a harvest.</summary>
/// <param name="format">How it is named, written and read.</param>
internal abstract class CaptureChannel(FrameChannel format)
{
    /// <summary>How it is named, written and read.</summary>
    public FrameChannel Format => format;

    /// <summary>Whether it needs the normals of the surfaces that the rays of a frame hit.</summary>
    public virtual bool NeedsNormals(GamePorts game) => false;

    /// <summary>Whether it needs what was found in the frame of the same view before.</summary>
    public virtual bool NeedsFrameBefore => false;

    /// <summary>Whether a harvest has it.</summary>
    public virtual bool IsOn(HarvestOptions options) => options.Channels.Contains(format.Key);

    /// <summary>Why a harvest that has it cannot start; null if it can.</summary>
    public virtual string? ProblemFor(HarvestOptions options, GamePorts game) => null;

    /// <summary>The folders of its files; those of the views of a rig lie in them.</summary>
    public virtual IEnumerable<string> FoldersFor(HarvestOptions options) => WithViews(format.Folders, options);

    /// <summary>Produces its part of each frame; null if it comes from elsewhere.</summary>
    /// <param name="options">The options of the camera.</param>
    /// <param name="rays">The rays of the frame.</param>
    /// <param name="game">The game.</param>
    public virtual IChannelLabeller? LabellerFor(LabellingOptions options, FrameRays rays, GamePorts game) => null;

    /// <summary>Folders, and in each the folders of the views of a rig.</summary>
    protected static IEnumerable<string> WithViews(IEnumerable<string> folders, HarvestOptions options) =>
        folders.SelectMany(folder => With(folder, options.Rig?.Cameras.Select(static camera => camera.Name) ?? []));

    /// <summary>A folder and folders in it.</summary>
    protected static IEnumerable<string> With(string folder, IEnumerable<string> inner) =>
        [folder, .. inner.Select(name => FramePaths.In(folder, name))];
}
