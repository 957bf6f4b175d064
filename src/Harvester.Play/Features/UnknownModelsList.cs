using System.Globalization;
using System.Text;
using Harvester.Capture.Ports;
using Harvester.Capture.Storage;
using Harvester.Play.Surveys.Faces;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Text;

namespace Harvester.Play.Features;

/// <summary>Lists the models near the camera that the table of faces lacks. The models of one run of the game are in one file.</summary>
public sealed class UnknownModelsList : ILastingFeature
{
    private const double RangeMetres = 100;
    private static readonly TimeSpan MaxWaitForDisk = TimeSpan.FromSeconds(10);
    private readonly IWorld _world;
    private readonly IProps _props;
    private readonly UnknownModels _unknown;
    private readonly string _folder;
    private readonly string _file = "unknown" + DateTime.Now.ToString("-yyyyMMdd-HHmmss", CultureInfo.InvariantCulture) + ".csv";
    private readonly PlayerMessages _messages;
    private readonly DiskQueue _disk = new();

    /// <summary>Creates the list.</summary>
    /// <param name="world">Gives the position of the camera.</param>
    /// <param name="props">The game's props.</param>
    /// <param name="table">Returns the currently known faces.</param>
    /// <param name="folder">The folder of the file.</param>
    /// <param name="messages">Reports the result.</param>
    public UnknownModelsList(IWorld world, IProps props, Func<FaceTable> table, string folder, PlayerMessages messages)
    {
        _world = world;
        _props = props;
        _unknown = new UnknownModels(table);
        _folder = folder;
        _messages = messages;
    }

    /// <inheritdoc/>
    public string Name => "The list of unknown models";

    /// <inheritdoc/>
    public bool IsOn => IsBusy;

    /// <inheritdoc/>
    public bool IsBusy => _disk.IsBusy;

    /// <summary>Why this game cannot list nearby entities; null if it can.</summary>
    public Func<string?> Problem { get; init; } = static () => null;

    /// <summary>Adds the nearby models, and writes the list.</summary>
    public void Look()
    {
        if (Problem() is { } problem)
        {
            _messages.Tell(problem);
            return;
        }

        _unknown.Look(_props.ReadProps(_world.ReadCamera().Pose.Position, RangeMetres));
        var text = new StringWriter(CultureInfo.InvariantCulture);
        _unknown.Write(text);
        _disk.Add(() =>
        {
            Directory.CreateDirectory(_folder);
            using var files = new SessionDirectory(_folder);
            byte[] bytes = new UTF8Encoding(false).GetBytes(text.ToString());
            files.WriteWhole(_file, stream => stream.Write(bytes, 0, bytes.Length));
        });
        string models = Counted.Of(_unknown.Models.Count, "model");
        _messages.Tell($"{models} nearby without a face in any table, listed in {Path.Combine(_folder, _file)}.");
    }

    /// <summary>Throws if the list could not be written.</summary>
    public void Tick()
    {
        if (_disk.TakeFailure() is { } failure)
        {
            throw new IOException(failure.Message, failure);
        }
    }

    /// <inheritdoc/>
    public void Stop() { }

    /// <inheritdoc/>
    public void Finish()
    {
        _disk.Wait(MaxWaitForDisk);
        Tick();
    }
}
