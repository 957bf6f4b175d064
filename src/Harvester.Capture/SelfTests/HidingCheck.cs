using Harvester.Capture.Harvesting;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Work;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.SelfTests;
using Harvester.Sessions.Text;

namespace Harvester.Capture.SelfTests;

/// <summary>Hides near objects of the frozen world one after another, and waits until each is gone from the picture.</summary>
internal sealed class HidingCheck(SelfTestContext context) : SelfCheck(context)
{
    private const int MaxObjects = 6;
    private const double MinBoxPixels = 300;

    /// <summary>Rays to the object, of which at least MinHits must meet it for it to count as visible.</summary>
    private const int RaysPerSide = 3;
    private const int MinHits = 4;

    /// <summary>Hiding that takes longer is not waited for, ticks.</summary>
    private const int MaxDelayTicks = 20;

    /// <summary>A pixel of a hidden object differs by more, grey levels.</summary>
    private const int ChangedLevels = 30;
    private const int MinPixels = 12;

    /// <summary>Hiding takes effect in the next tick; a tick more is no delay.</summary>
    private const int PromptTicks = 2;

    public override string Title => "hiding objects";

    public override IReadOnlyList<string> Checks => [SelfTestChecks.Hiding, SelfTestChecks.HidingDelay];

    public override IEnumerable<WorkStep> Run()
    {
        NeedPictures();
        if (Game.Visibility is not { } visibility)
        {
            throw new SelfTestException("this game offers no way to hide objects.");
        }

        yield return WorkStep.Do(Freeze());

        (int Entity, Box2D Box)[] objects = [.. Visible().Take(MaxObjects)];
        IReadOnlyCollection<int>? allowed;
        while ((allowed = visibility.Announce([.. objects.Select(each => each.Entity)])) is null)
        {
            yield return WorkStep.Tick;
        }

        objects = [.. objects.Where(each => allowed.Contains(each.Entity))];
        if (objects.Length == 0)
        {
            throw new SelfTestException("no object is near and in view.");
        }

        var delays = new List<int>();
        foreach ((int entity, Box2D box) in objects)
        {
            PixelBuffer before = Context.Grab();
            yield return WorkStep.Tick;
            int noise = PicturePixels.ChangedIn(box, before, Context.Grab(), ChangedLevels);
            visibility.HideOnly([entity]);
            int ticks = 0;
            bool isGone = false;
            while (!isGone && ticks < MaxDelayTicks + Context.PictureTicks)
            {
                yield return WorkStep.Tick;
                ticks++;
                isGone = PicturePixels.ChangedIn(box, before, Context.Grab(), ChangedLevels) > (2 * noise) + MinPixels;
            }

            if (isGone)
            {
                delays.Add(ticks - (Context.LagTicks ?? 0));
            }

            visibility.HideOnly([]);
            yield return WorkStep.Do(Wait(ticks + 1));
        }

        Judge(objects.Length, delays);
    }

    public override void Release() => Game.Visibility?.ShowAll();

    private void Judge(int asked, List<int> delays)
    {
        Context.Add(
            SelfTestChecks.Hiding,
            delays.Count == asked ? SelfTestVerdict.Good : SelfTestVerdict.Problem,
            $"{delays.Count} of {asked} objects disappear from the picture of the frozen world when they are hidden."
        );
        if (delays.Count > 0)
        {
            int delay = delays.Max();
            Context.Add(
                SelfTestChecks.HidingDelay,
                delay <= PromptTicks ? SelfTestVerdict.Good : SelfTestVerdict.Note,
                $"A hidden object is gone from the picture after {Counted.Of(delay, "tick")}."
            );
        }

        Context.AddUntested(Checks, "no object disappeared.");
    }

    /// <summary>The objects in view, the nearest first.</summary>
    private IEnumerable<(int Entity, Box2D Box)> Visible()
    {
        SceneSnapshot scene = Context.Reader.Read();
        CameraState state = scene.Camera;
        var camera = new Camera(
            state.Pose,
            new CameraIntrinsics(state.VerticalFovDegrees, Context.Options.Image, state.WindowAspect, state.NearClip, Context.Options.Lens)
        );
        return from entity in scene.Entities
            where entity.Handle != scene.Ego.Handle
            orderby (entity.Pose.Position - state.Pose.Position).Length
            let box = CuboidProjector.Project(camera, Cuboid.FromModel(entity.ModelMin, entity.ModelMax, entity.Pose)).Box
            where box is { } shown && shown.Area >= MinBoxPixels && IsHit(camera, shown, entity.Handle, scene.Ego.Handle)
            select (entity.Handle, box!.Value);
    }

    private bool IsHit(Camera camera, Box2D box, int entity, int ego)
    {
        int hits = 0;
        for (int number = 0; number < RaysPerSide * RaysPerSide; number++)
        {
            double u = box.XMin + (((number % RaysPerSide) + 0.5) / RaysPerSide * box.Width);
            double v = box.YMin + (((number / RaysPerSide) + 0.5) / RaysPerSide * box.Height);
            hits += Game.Rays.Cast(camera.RayThrough(u, v), Context.Options.RangeMetres, ego) is { } hit && hit.Entity == entity ? 1 : 0;
        }

        return hits >= MinHits;
    }
}
