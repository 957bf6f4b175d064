using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Work;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Scenes;

namespace Harvester.Play.Surveys.Faces;

/// <summary>
/// Measures models in turn: call <see cref="Step"/> once in every tick, from the game's own thread, until it is over. A model that the
/// folder records as done is skipped. After construction, nothing is thrown to the caller, and no model is left standing in the end.
/// </summary>
public sealed class FaceSurvey : IDisposable
{
    /// <summary>Maximum number of ticks until a model is loaded: ten seconds at 60 ticks per second.</summary>
    private const int MaxLoadingTicks = 600;

    /// <summary>Ticks from placing a model until rays hit it.</summary>
    private const int SettlingTicks = 2;

    private readonly ISurveyStage _stage;
    private readonly SurveyFolder _folder;
    private readonly List<SurveyedModel> _models;
    private readonly ModelPhotographer? _photographer;
    private readonly TickBudget _budget;
    private readonly WorkRun _run;
    private readonly HashSet<string> _asked = new(StringComparer.Ordinal);
    private string? _next;
    private int _standing;

    /// <summary>Creates a survey. The game is not used before the first step.</summary>
    /// <param name="stage">Places the models.</param>
    /// <param name="models">The models to measure.</param>
    /// <param name="folder">Receives the rows.</param>
    /// <param name="clock">Real time.</param>
    /// <param name="budgetMilliseconds">Maximum time of rays per tick, milliseconds.</param>
    /// <param name="camera">Takes photographs; null to take none.</param>
    public FaceSurvey(
        ISurveyStage stage,
        IEnumerable<SurveyedModel> models,
        SurveyFolder folder,
        IClock clock,
        double budgetMilliseconds,
        ISurveyCamera? camera = null
    )
    {
        _stage = stage ?? throw new ArgumentNullException(nameof(stage));
        _folder = folder ?? throw new ArgumentNullException(nameof(folder));
        _models = [.. models ?? throw new ArgumentNullException(nameof(models))];
        _photographer = camera is null ? null : new ModelPhotographer(camera, folder);
        _budget = new TickBudget(clock, budgetMilliseconds);
        _run = new WorkRun(Run(), () => _budget.IsSpent);
    }

    /// <summary>Number of models in the list.</summary>
    public int Models => _models.Count;

    /// <summary>Number of models that are done, including those of earlier surveys.</summary>
    public int Done { get; private set; }

    /// <summary>Whether the survey is over.</summary>
    public bool IsOver { get; private set; }

    /// <summary>The model that is being measured; empty before the first.</summary>
    public string Current { get; private set; } = string.Empty;

    /// <summary>Whether the screen is needed for a photograph, so that nothing may be drawn over it.</summary>
    public bool IsPhotographing => _photographer?.IsAtWork ?? false;

    /// <summary>Why the survey ended early, in one line; null without a fault.</summary>
    public string? Fault { get; private set; }

    /// <summary>Whether the game has refused to remove something at the end. <see cref="Dispose"/> tries again.</summary>
    public bool HasLeftSomething { get; private set; }

    /// <summary>Does the work of one tick. After the end it does nothing.</summary>
    public void Step()
    {
        if (IsOver)
        {
            return;
        }

        try
        {
            _budget.BeginTick();
            if (!_run.Advance())
            {
                End();
            }
            else if (_next is { } next)
            {
                // While one model is measured the game loads the next.
                Ask(next);
            }
        }
#pragma warning disable CA1031 // The game's script loop must not see an exception of ours, whatever its type.
        catch (Exception exception)
#pragma warning restore CA1031
        {
            Fault = $"The survey stopped: {exception.Message}";
            End();
        }
    }

    /// <summary>Ends the survey and removes what it placed.</summary>
    public void Dispose() => End();

    private IEnumerable<WorkStep> Run()
    {
        SurveyedModel[] left = [.. _models.Where(model => !_folder.IsDone(model.Name))];
        Done = _models.Count - left.Length;
        for (int i = 0; i < left.Length; i++)
        {
            Current = left[i].Name;
            _next = i + 1 < left.Length ? left[i + 1].Name : null;
            yield return WorkStep.Do(Measure(left[i]));

            Done++;
        }

        // A slow disk may report the failure of the last model's rows when all are measured.
        while (_folder.IsWriting)
        {
            yield return WorkStep.Tick;
        }

        _folder.Wait(TimeSpan.Zero);
    }

    private IEnumerable<WorkStep> Measure(SurveyedModel model)
    {
        ModelLoading loading = Ask(model.Name);
        for (int ticks = 0; loading == ModelLoading.Loading && ticks < MaxLoadingTicks; ticks++)
        {
            yield return WorkStep.Tick;
            loading = Ask(model.Name);
        }

        _standing = loading == ModelLoading.Loaded ? _stage.PutUp(model.Name) : 0;
        Release(model.Name);
        if (_standing == 0)
        {
            _folder.Finish(model.Name, loading == ModelLoading.Missing ? "missing" : "refused", []);
            yield break;
        }

        _stage.Hold(_standing);
        for (int ticks = 0; ticks < SettlingTicks; ticks++)
        {
            yield return WorkStep.Tick;
        }

        AssertStanding(model.Name);
        StagedModel staged = _stage.Read(_standing, model.Name);
        var probe = new StageProbe(_stage.Rays, staged);
        var faces = new FaceFinder(probe, staged);
        var heads = new HeadFinder(probe, staged);
        bool isLight = staged.Heads.Count > 0;
        yield return WorkStep.Do(isLight ? heads.Run() : faces.Run());

        IReadOnlyList<MeasuredFace> found = isLight ? heads.Heads : faces.Faces;
        if (_photographer is not null)
        {
            yield return WorkStep.Do(_photographer.Take(staged, model.Name, found));
        }

        AssertStanding(model.Name);
        TakeAway();
        bool isGuess = model.Class == ObjectClass.TrafficLight && !isLight;
        SurveyedModel shown = isLight ? model with { Class = ObjectClass.TrafficLight } : model;
        ModelFace[] rows = [.. found.Select((face, number) => RowOf(shown, face, number, isGuess))];
        IReadOnlyList<ModelFace> own = _folder.Table.Of(model.Name);
        _folder.Finish(
            model.Name,
            rows.Length == 0 ? "noFace" : "measured",
            rows.Length == 0 ? [] : KeptFaces.BesideFound(rows, own.Count > 0 ? own : model.Known)
        );
        yield return WorkStep.Tick;
    }

    private void AssertStanding(string model)
    {
        if (!_stage.IsStanding(_standing))
        {
            throw new InvalidOperationException($"the game removed {model} while it was measured.");
        }
    }

    private ModelLoading Ask(string model)
    {
        _asked.Add(model);
        return _stage.Load(model);
    }

    private void Release(string model)
    {
        _stage.Release(model);
        _asked.Remove(model);
    }

    private static ModelFace RowOf(SurveyedModel model, MeasuredFace face, int number, bool isGuess) =>
        new(
            model.Name,
            ModelHash.Of(model.Name),
            model.Class,
            number == 0 || model.Class == ObjectClass.TrafficLight ? model.SignName : string.Empty,
            number == 0 ? model.MutcdCode : string.Empty,
            number,
            new Vector3D(face.Min.X, face.Max.Y, face.Max.Z),
            new Vector3D(face.Max.X, face.Min.Y, face.Min.Z),
            face.Facing,
            face.IsWholeModel || isGuess ? Provenance.Derived : Provenance.Measured,
            isGuess ? "a light without bones of its heads: its widest part"
                : face.IsWholeModel ? "rays found no post: the whole model"
                : "rays in the game"
        );

    private void TakeAway()
    {
        int entity = _standing;
        if (entity != 0)
        {
            _stage.TakeAway(entity);
            _standing = 0;
        }
    }

    private void End()
    {
        IsOver = true;
        HasLeftSomething = false;
        Try(TakeAway);
        Try(() => _photographer?.LookAway());
        foreach (string model in _asked.ToArray())
        {
            Try(() => Release(model));
        }
    }

    private void Try(Action giveBack)
    {
        try
        {
            giveBack();
        }
#pragma warning disable CA1031 // The first fault is reported; the rest must be released all the same.
        catch (Exception exception)
#pragma warning restore CA1031
        {
            HasLeftSomething = true;
            Fault ??= $"The survey stopped: {exception.Message}";
        }
    }
}
