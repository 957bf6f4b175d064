using System;
using GTA.Math;
using GTA.Native;
using Harvester.Capture.Playing;
using Harvester.Capture.Roads;
using Harvester.Geometry;

namespace Harvester.Mod;

/// <summary>
/// The game's native functions that the mod calls, with their arguments in the types that they want. Natives hold on every build
/// that ScriptHookV serves, where the API's own members that read memory do not.
/// </summary>
internal static class Natives
{
    private const int GameRotationOrder = 2;
    private const int Opaque = 255;

    public static int PlayerPed() => Call<int>(Hash.PLAYER_PED_ID);

    public static bool EntityExists(int entity) => Call<bool>(Hash.DOES_ENTITY_EXIST, entity);

    /// <summary>1 for a ped, 2 for a vehicle, 3 for a prop, 0 for anything else, such as a building.</summary>
    public static int EntityType(int entity) => Call<int>(Hash.GET_ENTITY_TYPE, entity);

    public static Vector3D EntityPosition(int entity) => ToWorld(Call<Vector3>(Hash.GET_ENTITY_COORDS, entity, false));

    public static int EntityModel(int entity) => Call<int>(Hash.GET_ENTITY_MODEL, entity);

    public static Vector3D EntityVelocity(int entity) => ToWorld(Call<Vector3>(Hash.GET_ENTITY_VELOCITY, entity));

    public static float EntityHeading(int entity) => Call<float>(Hash.GET_ENTITY_HEADING, entity);

    public static Vector3 PointBeside(int entity, float right) =>
        Call<Vector3>(Hash.GET_OFFSET_FROM_ENTITY_IN_WORLD_COORDS, entity, right, 0f, 0f);

    /// <summary>The four vectors of an entity's matrix in one call, so that they belong together.</summary>
    public static Pose EntityPose(int entity)
    {
        using var forward = new OutputArgument();
        using var right = new OutputArgument();
        using var up = new OutputArgument();
        using var position = new OutputArgument();
        Call(Hash.GET_ENTITY_MATRIX, entity, forward, right, up, position);
        return new Pose(Vector(position), Axes.FromVectors(Vector(right), Vector(forward), Vector(up)));
    }

    /// <summary>The corners of a model's box in its own frame; they are not symmetric.</summary>
    public static (Vector3D Min, Vector3D Max) ModelDimensions(int model)
    {
        using var min = new OutputArgument();
        using var max = new OutputArgument();
        Call(Hash.GET_MODEL_DIMENSIONS, model, min, max);
        return (Vector(min), Vector(max));
    }

    /// <summary>The vehicle that a ped sits in, or 0.</summary>
    public static int VehicleOf(int ped) =>
        Call<bool>(Hash.IS_PED_IN_ANY_VEHICLE, ped, false) ? Call<int>(Hash.GET_VEHICLE_PED_IS_IN, ped, false) : 0;

    public static bool IsHuman(int ped) => Call<bool>(Hash.IS_PED_HUMAN, ped);

    public static int VehicleClass(int vehicle) => Call<int>(Hash.GET_VEHICLE_CLASS, vehicle);

    public static string VehicleDisplayName(int model) => Call<string>(Hash.GET_DISPLAY_NAME_FROM_VEHICLE_MODEL, model);

    public static bool IsVehicleModel(int model) =>
        Call<bool>(Hash.IS_MODEL_IN_CDIMAGE, model) && Call<bool>(Hash.IS_MODEL_A_VEHICLE, model);

    public static void RequestModel(int model) => Call(Hash.REQUEST_MODEL, model);

    public static bool HasModelLoaded(int model) => Call<bool>(Hash.HAS_MODEL_LOADED, model);

    public static void ReleaseModel(int model) => Call(Hash.SET_MODEL_AS_NO_LONGER_NEEDED, model);

    /// <summary>Makes a vehicle: its handle, or 0 when the game's pool is full.</summary>
    public static int CreateVehicle(int model, Vector3 position, float headingDegrees) =>
        Call<int>(Hash.CREATE_VEHICLE, model, position.X, position.Y, position.Z, headingDegrees, false, false);

    public static void DeleteVehicle(int vehicle)
    {
        Call(Hash.SET_ENTITY_AS_MISSION_ENTITY, vehicle, false, true);
        using var handle = new OutputArgument(vehicle);
        Call(Hash.DELETE_VEHICLE, handle);
    }

    public static void PlaceOnGround(int vehicle) => Call(Hash.SET_VEHICLE_ON_GROUND_PROPERLY, vehicle);

    public static void MakeUnbreakable(int vehicle)
    {
        Call(Hash.SET_VEHICLE_TYRES_CAN_BURST, vehicle, false);
        Call(Hash.SET_VEHICLE_CAN_BE_VISIBLY_DAMAGED, vehicle, false);
        Call(Hash.SET_VEHICLE_WHEELS_CAN_BREAK, vehicle, false);
    }

    public static void Paint(int vehicle, int primaryColour, int secondaryColour) =>
        Call(Hash.SET_VEHICLE_COLOURS, vehicle, primaryColour, secondaryColour);

    public static void SetPlate(int vehicle, string text) => Call(Hash.SET_VEHICLE_NUMBER_PLATE_TEXT, vehicle, text);

    public static int CreateCamera(float verticalFovDegrees) =>
        Call<int>(Hash.CREATE_CAM_WITH_PARAMS, "DEFAULT_SCRIPTED_CAMERA", 0f, 0f, 0f, 0f, 0f, 0f, verticalFovDegrees, true, GameRotationOrder);

    public static bool CameraExists(int camera) => Call<bool>(Hash.DOES_CAM_EXIST, camera);

    /// <summary>Makes a camera ride on an entity with its whole matrix, position and rotation; the offset is in the entity's frame.</summary>
    public static void AttachRigidly(int camera, int entity, Vector3D offset) =>
        Call(
            Hash.HARD_ATTACH_CAM_TO_ENTITY, camera, entity, 0f, 0f, 0f, (float)offset.X, (float)offset.Y, (float)offset.Z, true);

    public static void SetCameraActive(int camera, bool active) => Call(Hash.SET_CAM_ACTIVE, camera, active);

    public static void DestroyCamera(int camera) => Call(Hash.DESTROY_CAM, camera, false);

    public static int RenderingCamera() => Call<int>(Hash.GET_RENDERING_CAM);

    /// <summary>Shows scripted cameras or the game's own, at once.</summary>
    public static void RenderScriptedCameras(bool render)
    {
        const int easeMilliseconds = 0;
        Call(Hash.RENDER_SCRIPT_CAMS, render, false, easeMilliseconds, true, false);
    }

    public static Vector3D RenderedCameraPosition() => ToWorld(Call<Vector3>(Hash.GET_FINAL_RENDERED_CAM_COORD));

    public static EulerAngles RenderedCameraRotation()
    {
        Vector3 degrees = Call<Vector3>(Hash.GET_FINAL_RENDERED_CAM_ROT, GameRotationOrder);
        return new EulerAngles(degrees.X, degrees.Y, degrees.Z);
    }

    public static float RenderedVerticalFovDegrees() => Call<float>(Hash.GET_FINAL_RENDERED_CAM_FOV);

    public static float RenderedNearClip() => Call<float>(Hash.GET_FINAL_RENDERED_CAM_NEAR_CLIP);

    public static float WindowAspect() => Call<float>(Hash.GET_ASPECT_RATIO, false);

    public static void SetPaused(bool paused) => Call(Hash.SET_GAME_PAUSED, paused);

    public static int FrameCount() => Call<int>(Hash.GET_FRAME_COUNT);

    public static int GameTimerMilliseconds() => Call<int>(Hash.GET_GAME_TIMER);

    public static TimeSpan TimeOfDay() =>
        new(Call<int>(Hash.GET_CLOCK_HOURS), Call<int>(Hash.GET_CLOCK_MINUTES), Call<int>(Hash.GET_CLOCK_SECONDS));

    public static int WeatherHash() => Call<int>(Hash.GET_PREV_WEATHER_TYPE_HASH_NAME);

    /// <summary>What a line meets. The synchronous probe answers in the same frame; its arguments go as ints, because enums are slow.</summary>
    /// <returns>The point and the handle of what was hit, 0 for none; null when nothing was hit.</returns>
    public static (Vector3D Point, int Entity)? Probe(Vector3D start, Vector3D end, int intersectFlags, int ignoredEntity, int options)
    {
        int test = Call<int>(
            Hash.START_EXPENSIVE_SYNCHRONOUS_SHAPE_TEST_LOS_PROBE,
            (float)start.X, (float)start.Y, (float)start.Z, (float)end.X, (float)end.Y, (float)end.Z, intersectFlags, ignoredEntity, options);
        using var hit = new OutputArgument();
        using var point = new OutputArgument();
        using var normal = new OutputArgument();
        using var entity = new OutputArgument();
        const int ready = 2;
        int state = Call<int>(Hash.GET_SHAPE_TEST_RESULT, test, hit, point, normal, entity);
        if (state != ready)
        {
            throw new InvalidOperationException("The game did not answer a ray.");
        }

        return hit.GetResult<bool>() ? (Vector(point), entity.GetResult<int>()) : null;
    }

    /// <summary>Gives back the script handle that a ray has made for something; thousands of them would fill the game's pool.</summary>
    public static void ReleaseScriptHandle(int entity) => Call(Hash.RELEASE_SCRIPT_GUID_FROM_ENTITY, entity);

    /// <summary>Keeps the road nodes of a square loaded during this frame; whether they are.</summary>
    public static bool RequestRoadNodes(Vector3D centre, double range)
    {
        float west = (float)(centre.X - range), south = (float)(centre.Y - range), east = (float)(centre.X + range), north = (float)(centre.Y + range);
        Call(Hash.REQUEST_PATH_NODES_IN_AREA_THIS_FRAME, west, south, east, north);
        return Call<bool>(Hash.ARE_NODES_LOADED_FOR_AREA, west, south, east, north);
    }

    /// <summary>The n-th closest road node, and its place; null where the game has not so many.</summary>
    public static SurveyedNode? NthClosestRoadNode(Vector3D place, int number)
    {
        const int withSwitchedOffAndBoats = 1 | 2;
        const float weightOfHeight = 3;
        const float freeHeight = 0;
        int node = Call<int>(
            Hash.GET_NTH_CLOSEST_VEHICLE_NODE_ID,
            (float)place.X, (float)place.Y, (float)place.Z, number, withSwitchedOffAndBoats, weightOfHeight, freeHeight);

        // The game ends when it is asked for the place of a node that is none.
        if (node == 0)
        {
            return null;
        }

        using var position = new OutputArgument();
        Call(Hash.GET_VEHICLE_NODE_POSITION, node, position);
        return new SurveyedNode(node, Vector(position));
    }

    /// <summary>Traffic density and flags of the closest road node.</summary>
    public static SurveyedProperties? RoadNodeProperties(Vector3D place)
    {
        using var density = new OutputArgument();
        using var flags = new OutputArgument();
        return Call<bool>(Hash.GET_VEHICLE_NODE_PROPERTIES, (float)place.X, (float)place.Y, (float)place.Z, density, flags)
            ? new SurveyedProperties(density.GetResult<int>(), flags.GetResult<int>())
            : null;
    }

    /// <summary>The piece of road closest to a point, of any length and number of lanes; null when there is none.</summary>
    public static SurveyedRoad? ClosestRoad(Vector3D place)
    {
        const float shortestMetres = 0;
        const int fewestLanes = 0;
        const bool ignoreSwitchedOff = false;
        using var first = new OutputArgument();
        using var second = new OutputArgument();
        using var toFirst = new OutputArgument();
        using var toSecond = new OutputArgument();
        using var median = new OutputArgument();
        return Call<bool>(
            Hash.GET_CLOSEST_ROAD,
            (float)place.X, (float)place.Y, (float)place.Z, shortestMetres, fewestLanes, first, second, toFirst, toSecond, median, ignoreSwitchedOff)
            ? new SurveyedRoad(Vector(first), Vector(second), toFirst.GetResult<int>(), toSecond.GetResult<int>(), median.GetResult<float>())
            : null;
    }

    /// <summary>Draws a ball this frame; the game's sphere without a texture, as large as its scale is its radius.</summary>
    public static void DrawBall(Vector3D centre, double radius, Colour colour)
    {
        const int sphere = 28;
        const int noTexture = 0;
        float scale = (float)radius;
        Call(
            Hash.DRAW_MARKER, sphere, (float)centre.X, (float)centre.Y, (float)centre.Z, 0f, 0f, 0f, 0f, 0f, 0f, scale, scale, scale,
            colour.Red, colour.Green, colour.Blue, Opaque, false, false, GameRotationOrder, false, noTexture, noTexture, false);
    }

    public static void HideHudAndRadar() => Call(Hash.HIDE_HUD_AND_RADAR_THIS_FRAME);

    /// <summary>Hides the messages above the map this frame.</summary>
    public static void HideFeed() => Call(Hash.THEFEED_HIDE_THIS_FRAME);

    /// <summary>Draws a filled rectangle this frame; its centre and size are fractions of the window.</summary>
    public static void DrawRectangle(double centreX, double centreY, double width, double height, Colour colour) =>
        Call(
            Hash.DRAW_RECT, (float)centreX, (float)centreY, (float)width, (float)height, colour.Red, colour.Green, colour.Blue, Opaque, false);

    /// <summary>Writes a line this frame; the place of its upper left corner is in fractions of the window. The game cuts at 99 bytes.</summary>
    public static void DrawText(string text, double left, double top)
    {
        const float scale = 0.35f;
        const int white = 255;
        Call(Hash.SET_TEXT_FONT, 0);
        Call(Hash.SET_TEXT_SCALE, scale, scale);
        Call(Hash.SET_TEXT_COLOUR, white, white, white, Opaque);
        Call(Hash.SET_TEXT_OUTLINE);
        Call(Hash.BEGIN_TEXT_COMMAND_DISPLAY_TEXT, "STRING");
        Call(Hash.ADD_TEXT_COMPONENT_SUBSTRING_PLAYER_NAME, text);
        Call(Hash.END_TEXT_COMMAND_DISPLAY_TEXT, (float)left, (float)top, 0);
    }

    // An array on purpose: the API's overloads by number of arguments are not the same in all versions.
    private static T Call<T>(Hash native, params InputArgument[] arguments) => Function.Call<T>(native, arguments);

    private static void Call(Hash native, params InputArgument[] arguments) => Function.Call(native, arguments);

    private static Vector3D Vector(OutputArgument written) => ToWorld(written.GetResult<Vector3>());

    private static Vector3D ToWorld(Vector3 vector) => new(vector.X, vector.Y, vector.Z);
}
