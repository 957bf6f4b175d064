using Harvester.Capture.Ports;
using Harvester.Play.Surveys.Faces;
using Harvester.Sessions.Faces;

namespace Harvester.Play.Features;

/// <summary>The folder with the player's measurements, opened on another thread on first use, and the faces in use.</summary>
/// <param name="path">The folder.</param>
/// <param name="shipped">The faces shipped with the mod.</param>
/// <param name="inUse">The faces in use until the folder is opened.</param>
public sealed class MeasuredFaces(string path, FaceTable shipped, FaceTable inUse)
{
    private static readonly TimeSpan MaxWaitForDisk = TimeSpan.FromSeconds(10);
    private Task<SurveyFolder>? _opening;
    private FaceTable? _taken;

    /// <summary>The folder.</summary>
    public string Path { get; } = path;

    /// <summary>
    /// The faces in use: the measured ones, once they are read, take precedence over the shipped ones. The table changes only if its rows
    /// do.
    /// </summary>
    public FaceTable InUse
    {
        get
        {
            if (_opening is { } opening && IsOpened(opening) && opening.Result.Table != _taken)
            {
                _taken = opening.Result.Table;
                inUse = shipped.OverriddenBy(_taken);
            }

            return inUse;
        }
    }

    /// <summary>Whether something is still being read or written.</summary>
    public bool IsBusy => _opening is { } opening && (!opening.IsCompleted || (!opening.IsFaulted && opening.Result.IsWriting));

    /// <summary>The folder's content; null until it is read.</summary>
    /// <exception cref="IOException">It cannot be read. The next call tries again.</exception>
    public SurveyFolder? Open()
    {
        _opening ??= Task.Run(() => new SurveyFolder(Path));
        if (_opening.IsFaulted)
        {
            Exception failure = _opening.Exception!.InnerException!;
            _opening = null;
            throw new IOException(failure.Message, failure);
        }

        return IsOpened(_opening) ? _opening.Result : null;
    }

    private static bool IsOpened(Task<SurveyFolder> opening) =>
        Background.IsDone(nameof(SurveyFolder), () => opening.Status == TaskStatus.RanToCompletion);

    /// <summary>Waits until everything is written, or for as long as a script may take to end.</summary>
    /// <exception cref="IOException">Something could not be written.</exception>
    public void Wait()
    {
        if (_opening is { } opening && Task.WaitAny([opening], MaxWaitForDisk) == 0 && !opening.IsFaulted)
        {
            opening.Result.Wait(MaxWaitForDisk);
        }
    }
}
